package sunbeam.app.scene.texture;

import sunbeam.precompute.color.Srgb;

/** The linear light at which each of sRGB's 256 channels begins, and for ranges of light the channel to begin looking at. */
final class SrgbSteps {
    private static final int CHANNELS = 256;
    // Of light. The channels of the darkest lie 3e-4 apart, so that few have more than one step.
    private static final int RANGES = 4096;
    private static final double[] BEGINS = begins();
    private static final short[] FIRST = first();

    private SrgbSteps() {}

    /** {@link Srgb#channel}, as an unsigned byte. */
    static byte channel(double linear) {
        double clipped = Math.min(1, Math.max(0, linear));
        int channel = FIRST[(int) (RANGES * clipped)];
        while (clipped >= BEGINS[channel + 1]) {
            channel++;
        }
        return (byte) channel;
    }

    private static double[] begins() {
        double[] begins = new double[CHANNELS + 1];
        for (int channel = 1; channel < CHANNELS; channel++) {
            begins[channel] = Srgb.linear(channel - 0.5);
        }
        begins[CHANNELS] = Double.POSITIVE_INFINITY;
        return begins;
    }

    private static short[] first() {
        short[] first = new short[RANGES + 1];
        int channel = 0;
        for (int range = 0; range <= RANGES; range++) {
            while ((double) range / RANGES >= BEGINS[channel + 1]) {
                channel++;
            }
            first[range] = (short) channel;
        }
        return first;
    }
}
