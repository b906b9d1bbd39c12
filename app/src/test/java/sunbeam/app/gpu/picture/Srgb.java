package sunbeam.app.gpu.picture;

import org.joml.Matrix3d;
import org.joml.Vector3d;

/**
 * sRGB in double precision, from what IEC 61966-2-1 defines: the primaries' chromaticities, D65 and the curve. The
 * picture of an XYZ is found by bisection along the way to grey, not by the shader's formula.
 */
final class Srgb {
    /** White: D65 of the 2 degree observer (ASTM E308), as in the matrices in use. */
    static final Vector3d WHITE = new Vector3d(0.95047, 1, 1.08883);

    private static final double[][] PRIMARIES = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
    // Down to 2^-400: shares of colours of 1e30 as well.
    private static final int BISECTIONS = 400;

    private Srgb() {}

    /** Linear red, green, blue to XYZ. */
    static Matrix3d toXyz() {
        Matrix3d columns = new Matrix3d();
        for (int i = 0; i < 3; i++) {
            double x = PRIMARIES[i][0];
            double y = PRIMARIES[i][1];
            columns.setColumn(i, x / y, 1, (1 - x - y) / y);
        }
        Vector3d luminances = new Matrix3d(columns).invert().transform(new Vector3d(WHITE));
        return columns.mul(new Matrix3d().scaling(luminances));
    }

    /** XYZ to linear red, green, blue. */
    static Matrix3d fromXyz() {
        return toXyz().invert();
    }

    static double encoded(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
    }

    static double decoded(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /** The linear colour nearest to {@code rgb} on its way to the grey of its luminance that a display can show. */
    static Vector3d shown(Vector3d rgb, double luminance) {
        double grey = Math.min(1, Math.max(0, luminance));
        return at(share(rgb, luminance), rgb, luminance, grey);
    }

    /** How much of the saturation is kept: the largest share in [0, 1] at which all channels lie in [0, 1]. */
    static double share(Vector3d rgb, double luminance) {
        double grey = Math.min(1, Math.max(0, luminance));
        if (fits(at(1, rgb, luminance, grey))) {
            return 1;
        }
        double inside = 0;
        double outside = 1;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (inside + outside);
            if (fits(at(middle, rgb, luminance, grey))) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return inside;
    }

    private static Vector3d at(double share, Vector3d rgb, double luminance, double grey) {
        return new Vector3d(rgb).sub(luminance, luminance, luminance).mul(share).add(grey, grey, grey);
    }

    private static boolean fits(Vector3d rgb) {
        return Math.min(rgb.x, Math.min(rgb.y, rgb.z)) >= 0 && Math.max(rgb.x, Math.max(rgb.y, rgb.z)) <= 1;
    }
}
