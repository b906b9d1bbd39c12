package sunbeam.precompute.patch;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.setting.SettingException;

/** Picks the channel that holds the heights and reads it; what is transparent counts as missing. */
final class ChannelReader {
    private final Path file;
    private final ImageBands bands;

    ChannelReader(Path file, ImageBands bands) {
        this.file = file;
        this.bands = bands;
    }

    /**
     * The channel to read: the wanted one, else grey of a grey image and red of an RGB image with equal channels.
     *
     * @throws PatchException when the image lacks the channel, or shows its heights in false colours
     * @throws SettingException when RGB differs and none is chosen
     */
    Channel choose(Optional<Channel> wanted) {
        boolean coloured =
                wanted.filter(channel -> channel == Channel.ALPHA).isEmpty() && bands.isColour() && !coloursAreEqual();
        if (coloured && FalseColours.in(bands)) {
            throw new PatchException(
                    file + " looks like a picture in false colours, which follow a colour map: no channel of"
                            + " it is a height; export the heights themselves (.gwy, .gsf, text, 16-bit grey)");
        }
        if (wanted.isEmpty() || wanted.get() == Channel.GREY) {
            if (coloured) {
                throw new SettingException(
                        PatchSettings.CHANNEL,
                        (wanted.isEmpty() ? "is missing: " : "is not enough: ") + file
                                + " is coloured, its red, green and blue differ; say which of them holds the heights");
            }
            return bands.isColour() ? Channel.RED : Channel.GREY;
        }
        Channel channel = wanted.get();
        boolean there = channel == Channel.ALPHA ? bands.hasAlpha() : bands.isColour();
        if (!there) {
            throw new PatchException(String.format(
                    Locale.ROOT,
                    "%s (%s) has no channel %s; leave the channel out or choose another",
                    file,
                    bands.description(),
                    channel.label()));
        }
        return channel;
    }

    /** All samples of the channel, row by row; NaN where the alpha channel, if any, is 0. */
    double[] read(Channel channel) {
        int columns = bands.columns();
        int band = band(channel);
        boolean masked = bands.hasAlpha() && channel != Channel.ALPHA;
        double[] samples = new double[Math.multiplyExact(columns, bands.rows())];
        double[] row = new double[columns];
        for (int r = 0; r < bands.rows(); r++) {
            bands.read(band, r, row);
            System.arraycopy(row, 0, samples, r * columns, columns);
            if (masked) {
                bands.read(bands.alphaBand(), r, row);
                mask(samples, r * columns, row);
            }
        }
        return samples;
    }

    private void mask(double[] samples, int offset, double[] alpha) {
        for (int column = 0; column < alpha.length; column++) {
            if (alpha[column] == 0) {
                samples[offset + column] = Double.NaN;
            } else if (bands.isPremultiplied()
                    && alpha[column] != bands.format().fullScale()) {
                throw new PatchException(file + " stores colours multiplied by alpha; save it without transparency");
            }
        }
    }

    private int band(Channel channel) {
        return switch (channel) {
            case GREY, RED -> 0;
            case GREEN -> 1;
            case BLUE -> 2;
            case ALPHA -> bands.alphaBand();
        };
    }

    private boolean coloursAreEqual() {
        double[] red = new double[bands.columns()];
        double[] other = new double[bands.columns()];
        for (int row = 0; row < bands.rows(); row++) {
            bands.read(0, row, red);
            for (int band = 1; band < 3; band++) {
                bands.read(band, row, other);
                if (!Arrays.equals(red, other)) {
                    return false;
                }
            }
        }
        return true;
    }
}
