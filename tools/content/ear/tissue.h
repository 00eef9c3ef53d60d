#pragma once
// What each tissue of the ear looks like at a place. Colours are linear; places in W's millimetres.

#include "tools/content/ear/flesh.h"

namespace fulcrum::content::tissue {

Eigen::Vector3d skin(const Flesh& flesh, const Eigen::Vector3d& p);
Eigen::Vector3d lining(const Eigen::Vector3d& p);  // of the canal
Eigen::Vector3d mucosa(const Eigen::Vector3d& p);  // of the tympanic cavity
Eigen::Vector3d drum(const Canal& canal, const Eigen::Vector3d& p);
// On the face of the cut: skin, fat, cartilage in the canal's outer third, bone with air cells further in.
Eigen::Vector3d cut(const Flesh& flesh, const Eigen::Vector3d& p);

}  // namespace fulcrum::content::tissue
