package sunbeam.precompute.color;

/** Transform from linear CIE XYZ, times an exposure above 0, to display light: linear sRGB, gamut, tone (shaders/include/display.glsl). */
public record DisplayTransform(double exposure, Tone tone, Primaries primaries) {
    public DisplayTransform(double exposure, Tone tone) {
        this(exposure, tone, Primaries.SRGB);
    }

    /** Computes the linear sRGB display light, 0 to 1, of X, Y, Z before exposure; Y of 0 or below is black. */
    public void light(float[] xyz, int offset, double[] rgb) {
        light(xyz[offset], xyz[offset + 1], xyz[offset + 2], rgb);
    }

    private void light(double x, double y, double z, double[] rgb) {
        double luminance = exposure * y;
        if (!(luminance > 0 && luminance < Double.POSITIVE_INFINITY)) {
            rgb[0] = rgb[1] = rgb[2] = luminance > 0 ? 1 : 0;
            return;
        }
        primaries.channels(exposure * x, luminance, exposure * z, rgb);
        tone.apply(rgb);
    }

    /** Returns 0xRRGGBB of linear X, Y, Z before exposure, with the sRGB curve. */
    public int rgb(double[] xyz) {
        double[] light = new double[3];
        light(xyz[0], xyz[1], xyz[2], light);
        return packed(light);
    }

    /** Returns 0xRRGGBB of linear display light, from 0 to 1 in each channel. */
    public static int packed(double[] light) {
        return Srgb.channel(light[0]) << 16 | Srgb.channel(light[1]) << 8 | Srgb.channel(light[2]);
    }

    /** Primaries of the linear RGB values that are sent to the screen. */
    public enum Primaries {
        /** sRGB. Colors outside its gamut move towards the gray of their luminance. */
        SRGB,

        /** CIE 1931 RGB, as in the thesis's shader; on an sRGB screen its white is bluish. Negative channels are clipped. */
        CIE_RGB;

        // Inverse of the matrix whose columns are X, Y, Z of red, green and blue: (0.49, 0.17697, 0),
        // (0.31, 0.8124, 0.01) and (0.2, 0.01063, 0.99), each over 0.17697.
        private static final double[][] CIE_RGB_OF_XYZ = {
            {2.36461385, -0.89654057, -0.46807328},
            {-0.51516621, 1.42640810, 0.08875810},
            {0.00520370, -0.01440816, 1.00920446}
        };

        public static Primaries of(boolean thesis) {
            return thesis ? CIE_RGB : SRGB;
        }

        void channels(double x, double y, double z, double[] rgb) {
            if (this == CIE_RGB) {
                for (int c = 0; c < 3; c++) {
                    double[] row = CIE_RGB_OF_XYZ[c];
                    rgb[c] = Math.max(0, row[0] * x + row[1] * y + row[2] * z);
                }
                return;
            }
            for (int c = 0; c < 3; c++) {
                rgb[c] = Srgb.linear(c, x, y, z);
            }
            double least = Math.min(0, Math.min(rgb[0], Math.min(rgb[1], rgb[2])));
            double kept = y / (y - least);
            for (int c = 0; c < 3; c++) {
                rgb[c] = kept * (rgb[c] - least);
            }
        }
    }

    /**
     * Tone mapping of light brighter than the screen's white (1), in linear sRGB. Red, green and blue are scaled together, which keeps the
     * hue: the largest of them, m, stays m up to s and becomes 1 - (1 - s)^2 / (m + 1 - 2 s) above. Colors much brighter than white lose
     * saturation. The form is that of the Khronos PBR Neutral tone mapper (2024); start and desaturation differ, since first orders are
     * several times brighter than white.
     */
    public enum Tone {
        COMPRESS(0.5),

        /** Clips each channel at 1, as in the thesis. */
        CLIP(Float.MAX_VALUE),

        /** Clips and raises to 2.4 / 2.5, so that the exponent of sRGB's curve is 1 / 2.5, as in the thesis's program. */
        GAMMA(Float.MAX_VALUE);

        private static final double PROGRAM_GAMMA = 2.4 / 2.5;
        // Light at a hundred times white loses a third of its saturation.
        private static final double DESATURATION = 0.005;
        private static final double BRIGHTEST_SHOWN = Srgb.linear(254);
        // Largest input; brighter colors are white on any screen.
        private static final double BRIGHTEST = 1e9;

        private final double start;

        public static Tone of(boolean thesis) {
            return thesis ? CLIP : COMPRESS;
        }

        Tone(double start) {
            this.start = start;
        }

        /** Returns s, the largest channel value that is not compressed. */
        public double start() {
            return start;
        }

        /** Inverts the compression of the largest channel, 0 to 1; values above that of the 8-bit 254 count as it, since 1 has no inverse. */
        public double before(double shown) {
            if (this == GAMMA) {
                return Math.pow(shown, 1 / PROGRAM_GAMMA);
            }
            if (shown <= start) {
                return shown;
            }
            double room = 1 - start;
            return room * room / (1 - Math.min(shown, BRIGHTEST_SHOWN)) - room + start;
        }

        void apply(double[] rgb) {
            double largest = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
            if (largest > start) {
                double room = 1 - start;
                double bounded = Math.min(largest, BRIGHTEST);
                double compressed = 1 - room * room / (bounded + room - start);
                double white = 1 - 1 / (DESATURATION * (bounded - compressed) + 1);
                for (int c = 0; c < 3; c++) {
                    double share = rgb[c] / largest;
                    rgb[c] = compressed * (share + white * (1 - share));
                }
            }
            for (int c = 0; c < 3; c++) {
                rgb[c] = Math.min(1, rgb[c]);
                rgb[c] = this == GAMMA ? Math.pow(rgb[c], PROGRAM_GAMMA) : rgb[c];
            }
        }
    }
}
