package sunbeam.app.scene.environment;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/**
 * Reader of Radiance's pictures of all directions (.hdr; G. Ward, "Real Pixels", Graphics Gems II, 1991). A large file is averaged over
 * squares of pixels, row by row. So it takes as little memory as a small one, and the light of each pixel counts.
 */
final class RadianceFile {
    /** Width of the largest file. */
    private static final int MOST_WIDTH = 1 << 15;

    // A brighter pixel is damaged: the sun has some 1e9 cd/m^2.
    private static final double BRIGHTEST = 1e15;
    private static final int LONGEST_LINE = 1000;
    private static final int MOST_LINES = 200;
    private static final Pattern SIZE = Pattern.compile("-Y (\\d{1,9}) \\+X (\\d{1,9})");
    private static final int CHANNELS = 4;

    private final Path file;
    private final InputStream bytes;
    private double exposure = 1;

    private RadianceFile(Path file, InputStream bytes) {
        this.file = file;
        this.bytes = bytes;
    }

    /** Throws InputException if the file is missing, no such picture, not twice as wide as high, damaged or black. */
    static RadianceMap read(Path file) {
        InputException.requireRegular(file);
        try (InputStream stream = new BufferedInputStream(Files.newInputStream(file))) {
            return new RadianceFile(file, stream).read();
        } catch (EOFException end) {
            throw new InputException("environment " + file + " ends too early; export it again", end);
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private void refuseIf(boolean condition, String problem) {
        InputException.refuseIf(condition, "environment " + file + " " + problem);
    }

    private RadianceMap read() throws IOException {
        refuseIf(!line().startsWith("#?"), "is no Radiance picture; convert it to .hdr (RGBE)");
        boolean isKnown = false;
        for (int i = 0; ; i++) {
            String line = line();
            if (line.isBlank()) {
                break;
            }
            refuseIf(i == MOST_LINES, "has a header without end; export it again");
            isKnown |= line.equals("FORMAT=32-bit_rle_rgbe");
            if (line.startsWith("EXPOSURE=")) {
                exposure *= exposure(line.substring("EXPOSURE=".length()).strip());
            }
        }
        refuseIf(!isKnown, "has no FORMAT=32-bit_rle_rgbe; convert it to .hdr (RGBE)");
        String size = line();
        Matcher sides = SIZE.matcher(size);
        refuseIf(!sides.matches(), "has the size " + Text.quoted(size) + "; save it as -Y height +X width");
        int height = Integer.parseInt(sides.group(1));
        int width = Integer.parseInt(sides.group(2));
        String pixels = "has " + width + " x " + height + " pixels; ";
        refuseIf(height < 1 || width != 2 * height, pixels + "a map of all directions is twice as wide as high");
        refuseIf(width > MOST_WIDTH, pixels + "make it at most " + MOST_WIDTH + " wide");
        return means(width, height);
    }

    private double exposure(String text) {
        double value;
        try {
            value = Double.parseDouble(text);
        } catch (NumberFormatException wrong) {
            value = Double.NaN;
        }
        refuseIf(
                !(value > 1e-12 && value < 1e12),
                "has EXPOSURE=" + Text.quoted(text) + ", by which its pixels are divided; give a number above 0");
        return value;
    }

    private RadianceMap means(int width, int height) throws IOException {
        int factor = (width + RadianceMap.MOST_WIDTH - 1) / RadianceMap.MOST_WIDTH;
        int rows = height / factor;
        refuseIf(rows * factor != height, "has " + height + " rows; make that at most 512, or a multiple of " + factor);
        double[] sums = new double[3 * 2 * rows];
        float[] rgb = new float[3 * 2 * rows * rows];
        byte[] line = new byte[CHANNELS * width];
        double scale = 1 / (exposure * factor * factor);
        for (int row = 0; row < height; row++) {
            readRow(line, width);
            for (int x = 0; x < width; x++) {
                int exponent = line[CHANNELS * x + 3] & 0xff;
                if (exponent > 0) {
                    double unit = scale * Math.scalb(1.0, exponent - 136);
                    for (int c = 0; c < 3; c++) {
                        sums[3 * (x / factor) + c] += ((line[CHANNELS * x + c] & 0xff) + 0.5) * unit;
                    }
                }
            }
            if (row % factor == factor - 1) {
                for (int i = 0; i < sums.length; i++) {
                    refuseIf(!(sums[i] < BRIGHTEST), "has a pixel of " + sums[i] + "; export it again");
                    rgb[row / factor * sums.length + i] = (float) sums[i];
                    sums[i] = 0;
                }
            }
        }
        RadianceMap map = new RadianceMap(rows, rgb);
        refuseIf(!(map.luminance() > 0), "is black; take one with light");
        return map;
    }

    private String line() throws IOException {
        StringBuilder line = new StringBuilder();
        for (int next = next(); next != '\n'; next = next()) {
            line.append((char) next);
            refuseIf(line.length() > LONGEST_LINE, "is no Radiance picture; convert it to .hdr (RGBE)");
        }
        return new String(line.toString().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.US_ASCII).strip();
    }

    private int next() throws IOException {
        int next = bytes.read();
        if (next < 0) {
            throw new EOFException();
        }
        return next;
    }

    /** Reads a row of RGBE, plain or with each channel in runs. */
    private void readRow(byte[] line, int width) throws IOException {
        int[] begin = {next(), next(), next(), next()};
        boolean inRuns = begin[0] == 2 && begin[1] == 2 && (begin[2] << 8 | begin[3]) == width && width < 1 << 15;
        if (!inRuns) {
            refuseIf(
                    begin[0] == 1 && begin[1] == 1 && begin[2] == 1,
                    "has runs of Radiance's oldest kind; export it again");
            for (int c = 0; c < CHANNELS; c++) {
                line[c] = (byte) begin[c];
            }
            if (bytes.readNBytes(line, CHANNELS, line.length - CHANNELS) < line.length - CHANNELS) {
                throw new EOFException();
            }
            return;
        }
        for (int c = 0; c < CHANNELS; c++) {
            for (int x = 0; x < width; ) {
                int code = next();
                int count = code > 128 ? code - 128 : code;
                refuseIf(count == 0 || x + count > width, "has a run beyond the end of its row; export it again");
                int repeated = code > 128 ? next() : 0;
                for (int end = x + count; x < end; x++) {
                    line[CHANNELS * x + c] = (byte) (code > 128 ? repeated : next());
                }
            }
        }
    }
}
