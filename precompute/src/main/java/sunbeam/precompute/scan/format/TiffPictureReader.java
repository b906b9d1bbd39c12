package sunbeam.precompute.scan.format;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of TIFF pictures: gray, RGB or with a palette, integers or floats. Each page has its own channels; reduced copies and masks are
 * skipped. ImageJ writes pixels per unit of length as the resolution; other programs' resolutions are for printers and ignored.
 */
final class TiffPictureReader {
    private static final int WHITE_IS_ZERO = 0;
    private static final int BLACK_IS_ZERO = 1;
    private static final int PALETTE = 3;
    private static final int PREMULTIPLIED = 1;
    private static final int ALPHA = 2;
    private static final int NO_IMAGE = 1 | 4;

    private static final Pattern UNIT = Pattern.compile("(?s)ImageJ=.*?\nunit=(\\V*).*");

    private TiffPictureReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        List<TiffPage> all = TiffPage.read(file);
        List<TiffPage> images = all.stream()
                .filter(page -> ((int) page.number(TIFF.TAG_SUBFILE_TYPE, 0) & NO_IMAGE) == 0)
                .toList();
        List<TiffPage> pages = images.isEmpty() ? all.subList(0, 1) : images;
        Matcher unit = UNIT.matcher(all.get(0).text(TIFF.TAG_IMAGE_DESCRIPTION));
        String lengthUnit = unit.matches() ? unit.group(1).replace("\\u00B5", "u") : "";
        List<ScanChannel> channels = new ArrayList<>(channels(pages.get(0), lengthUnit, pages.size() > 1));
        for (TiffPage page : pages.subList(1, pages.size())) {
            try {
                channels.addAll(channels(page, lengthUnit, true));
            } catch (ScanException unreadable) {
                // Such as a preview; the others may do.
            }
        }
        return channels;
    }

    private static List<ScanChannel> channels(TiffPage page, String unit, boolean several) throws IOException {
        int interpretation = (int) page.number(TIFF.TAG_PHOTOMETRIC_INTERPRETATION, BLACK_IS_ZERO);
        if (interpretation < WHITE_IS_ZERO || interpretation > PALETTE) {
            throw new ScanException(
                    "is a TIFF with photometric interpretation " + interpretation + "; save it as gray or RGB");
        }
        int extra = (int) page.number(TIFF.TAG_EXTRA_SAMPLES, 0);
        if (extra == PREMULTIPLIED) {
            throw new ScanException("stores colors multiplied by alpha; save it without transparency");
        }
        double fullScale = page.isFloat() ? 1 : Math.pow(2, page.bits()) - 1;
        double sign = interpretation == WHITE_IS_ZERO ? -1 : 1;
        List<Samples> bands = new ArrayList<>();
        for (int band = 0; band < page.bands(); band++) {
            Samples samples = page.samples(band);
            if (interpretation == PALETTE && band == 0) {
                bands.addAll(colors(samples, page.numbers(TIFF.TAG_COLOR_MAP)));
            } else {
                bands.add(samples.scale(sign / fullScale, interpretation == WHITE_IS_ZERO ? 1 : 0));
            }
        }
        int colors = interpretation > BLACK_IS_ZERO ? 3 : 1;
        if (bands.size() < colors) {
            throw new ScanException("has " + bands.size() + " channels where 3 colors are announced; export it again");
        }
        boolean alpha = extra == ALPHA && bands.size() > colors;
        return PictureReader.channels(
                several ? "page " + (page.index() + 1) + " " : "",
                bands.subList(0, colors),
                alpha ? Optional.of(bands.get(colors)) : Optional.empty(),
                extent(page, unit, bands.get(0)),
                page.isFloat() ? "" : ScanChannel.FULL_SCALE);
    }

    /** Palettes have 16 bits; some programs write 8. */
    private static List<Samples> colors(Samples indices, double[] palette) {
        int length = palette.length / 3;
        double fullScale = Arrays.stream(palette).max().orElse(0) > 255 ? 65_535 : 255;
        return IntStream.range(0, 3)
                .mapToObj(color -> indices.map(
                        index -> index < length ? palette[color * length + (int) index] / fullScale : Double.NaN))
                .toList();
    }

    private static Extent extent(TiffPage page, String unit, Samples samples) {
        double perUnitX = page.number(TIFF.TAG_X_RESOLUTION, 0);
        double perUnitY = page.number(TIFF.TAG_Y_RESOLUTION, perUnitX);
        return Extent.metersPer(unit).isPresent() && perUnitX > 0 && perUnitY > 0
                ? Extent.ofPitches(1 / perUnitX, 1 / perUnitY, unit, samples)
                : Extent.UNKNOWN;
    }
}
