// Wavelengths with their exact CIE weights: XYZ = sum of weight * power, 1 for the white of D65.

// One texel per node: wavelength in metres, weights of X, Y and Z.
uniform sampler2D wavelengthNodes;
uniform int wavelengthCount;
