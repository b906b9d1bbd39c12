// Values of w in geometry.frag's view image: the pixel shows the patch that is drawn, another patch, or no skin.
const float THIS_PATCH = 2.0;
const float OTHER_PATCH = 1.0;
const float NO_SKIN = 0.0;
