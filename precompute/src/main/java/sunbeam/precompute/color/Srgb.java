package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.stream.IntStream;

/** sRGB (IEC 61966-2-1): transfer curve and primaries with D65 white. shaders/include/srgb.glsl computes it in GLSL. */
public final class Srgb {
    private static final double[][] TO_XYZ = {
        {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}
    };

    private static final double[][] FROM_XYZ = {
        {3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}
    };
    // Lower limit of each 8-bit value in linear light; that of 256 lies beyond 1.
    private static final double[] BEGINS = IntStream.rangeClosed(0, 256)
            .mapToDouble(channel -> channel == 0 ? 0 : linear(channel - 0.5))
            .toArray();
    // Ranges of linear light, 2.4e-4 wide: the darkest 8-bit values lie 3e-4 apart, so no range holds two limits.
    private static final int RANGES = 4096;
    // 8-bit value at the start of each range: a picture's millions of values take a sixth of a binary search's time.
    private static final int[] FIRST = IntStream.rangeClosed(0, RANGES)
            .map(range -> Arrays.binarySearch(BEGINS, (double) range / RANGES))
            .map(found -> found >= 0 ? found : -2 - found)
            .toArray();

    private Srgb() {}

    /** Returns the linear light of an 8-bit value, also between whole values: 0 to 1 for 0 to 255. */
    public static double linear(double channel) {
        double encoded = channel / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /** Returns the nearest 8-bit value of linear light clamped to [0, 1]; 0 for NaN. */
    public static int channel(double linear) {
        double clipped = Math.min(1, Math.max(0, linear));
        int channel = FIRST[(int) (RANGES * clipped)];
        return clipped >= BEGINS[channel + 1] ? channel + 1 : channel;
    }

    /** Returns CIE XYZ of linear red, green and blue; Y = 1 for white. */
    public static double[] xyz(double red, double green, double blue) {
        double[] xyz = new double[3];
        for (int c = 0; c < 3; c++) {
            xyz[c] = TO_XYZ[c][0] * red + TO_XYZ[c][1] * green + TO_XYZ[c][2] * blue;
        }
        return xyz;
    }

    /** Returns linear red, green or blue (channel 0, 1, 2) of CIE X, Y, Z; outside 0 to 1 outside the gamut. */
    public static double linear(int channel, double x, double y, double z) {
        return FROM_XYZ[channel][0] * x + FROM_XYZ[channel][1] * y + FROM_XYZ[channel][2] * z;
    }
}
