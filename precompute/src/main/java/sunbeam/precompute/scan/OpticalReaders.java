package sunbeam.precompute.scan;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import sunbeam.precompute.scan.TextReader.TextNumbers;

/** Readers of files of optical profilers (Wyko, Zygo, Sensofar, Alicona, Keyence). Gwyddion and SurfaceTopography read the tests' files, too. */
final class OpticalReaders {
    private static final int BLOCK_BYTES = 24;
    private static final int BLOCK_NAME = 16;
    private static final int MOST_BLOCKS = 4096;
    private static final int SHORT_BLOCK = 6;
    private static final List<String> WYKO_HEIGHTS = List.of("RAW_DATA", "RAW DATA", "OPD", "Raw", "SAMPLE_DATA");
    private static final Map<Integer, SampleType> WYKO_TYPES =
            Map.of(1, SampleType.UNSIGNED_8, 2, SampleType.SIGNED_16, 4, SampleType.FLOAT_32);
    // Missing samples are these or larger.
    private static final double WYKO_MISSING_INTEGER = 32_766;
    private static final double WYKO_MISSING_FLOAT = 1e38;

    private static final double[] ZYGO_STEPS = {4096, 32_768, 131_072};
    private static final double ZYGO_MISSING = 2_147_483_640;

    private static final int SENSOFAR_TOPOGRAPHY = 3;
    private static final int SENSOFAR_LAYERS = 489;
    private static final int SENSOFAR_HEADER = 500;
    private static final double SENSOFAR_MISSING = 1_000_001;
    private static final int MOST_LAYERS = 16;

    private static final int ALICONA_KEY = 20;
    private static final int ALICONA_VALUE = 30;
    private static final int MOST_TAGS = 1000;
    private static final double ALICONA_ROUNDING = 1.5e-7;

    private static final int KEYENCE_HEIGHT_OFFSETS = 36;
    private static final int KEYENCE_IMAGES = 3;
    private static final int KEYENCE_PALETTE = 768;
    // Offset of a pixel's width in the settings, which begin four bytes earlier in .vk3; its height and step follow.
    private static final int KEYENCE_PITCH = 168;
    private static final Map<Integer, SampleType> KEYENCE_TYPES =
            Map.of(8, SampleType.UNSIGNED_8, 16, SampleType.UNSIGNED_16, 32, SampleType.UNSIGNED_32);

    private static final String BCR = "fileformat = bcr";
    private static final int BCR_HEADER = 2048;
    private static final double BCR_MISSING_FLOAT = 1.7e38;

    private OpticalReaders() {}

    /**
     * Reads .opd files by Wyko's Vision: a directory of blocks, each with a name, a type and a length, then the blocks. Samples go up the
     * columns, in units of wavelength (nm) over "Mult"; "Pixel_size" is in mm, "Aspect" the pitch of rows over that of columns.
     */
    static List<ScanChannel> wyko(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(2 + BLOCK_NAME + 2, ByteOrder.LITTLE_ENDIAN);
        long length = cursor.unsigned32();
        cursor.skip(2);
        ScanException.refuseIf(
                length / BLOCK_BYTES > MOST_BLOCKS, "claims more than " + MOST_BLOCKS + " blocks; export it again");
        long offset = 2 + length;
        Map<String, Long> blocks = new HashMap<>();
        Header values = new Header();
        while (cursor.position() + BLOCK_BYTES <= 2 + length) {
            String name = cursor.text(BLOCK_NAME);
            int type = cursor.int16();
            int bytes = Math.max(0, cursor.int32());
            cursor.skip(2);
            file.requireInside(offset, bytes);
            ScanBytes.Cursor block = file.cursor(offset, ByteOrder.LITTLE_ENDIAN);
            if (bytes == 2 || bytes == 4) {
                double value = bytes == 2 ? block.int16() : type == SHORT_BLOCK ? block.int32() : block.float32();
                values.put(name, Double.toString(value));
            }
            blocks.putIfAbsent(name, offset);
            offset += bytes;
        }
        Long start = WYKO_HEIGHTS.stream()
                .map(blocks::get)
                .filter(place -> place != null)
                .findFirst()
                .orElseThrow(() -> new ScanException("has no block of heights; export them again"));
        ScanBytes.Cursor head = file.cursor(start, ByteOrder.LITTLE_ENDIAN);
        int columns = head.unsigned16();
        int rows = head.unsigned16();
        SampleType type = SampleType.of(WYKO_TYPES, head.unsigned16());
        double missing = type == SampleType.FLOAT_32 ? WYKO_MISSING_FLOAT : WYKO_MISSING_INTEGER;
        Samples heights = Samples.of(file, head.position(), columns, rows, type)
                .map(sample -> sample < missing ? sample : Double.NaN)
                .reorder(i -> i % columns * rows + rows - 1 - i / columns);
        return List.of(wyko(values, heights));
    }

    private static ScanChannel wyko(Header values, Samples samples) {
        double scale = values.number("Wavelength") / values.number("Mult", 1);
        double aspect = values.number("Aspect", 1);
        boolean sized = values.number("Pixel_size", 0) > 0;
        double pitch = sized ? values.number("Pixel_size") : 1;
        Extent extent = Extent.ofPitches(pitch, pitch * aspect, sized ? "mm" : "", samples);
        return new ScanChannel("Height", samples.scale(scale, 0), extent, "nm");
    }

    /** Reads .asc files by Wyko's Vision: the same values in lines of name, type, length and value, then lines of x, y from the bottom, sample. */
    static List<ScanChannel> wykoText(ScanBytes file) throws IOException {
        String head = file.headBefore("RAW_DATA");
        Header values = new Header();
        head.lines().map(line -> line.split("\t", -1)).forEach(words -> values.put(words[0], words[words.length - 1]));
        int columns = values.count("X Size");
        int rows = values.count("Y Size");
        long before = head.lines().count();
        Samples samples = new Samples(columns, rows, () -> {
            Samples.requireMemory(3L * columns * rows, 0);
            int count = 3 * columns * rows;
            BufferedReader lines =
                    new BufferedReader(new InputStreamReader(file.stream(head.length()), StandardCharsets.ISO_8859_1));
            lines.readLine();
            double[] points = new TextNumbers(lines, false, TextFile.REMOVE, before + 2, count).first(count);
            double[] heights = new double[columns * rows];
            Arrays.fill(heights, Double.NaN);
            for (int i = 0; i < count; i += 3) {
                boolean inside = points[i] >= 0 && points[i] < columns && points[i + 1] >= 0 && points[i + 1] < rows;
                ScanException.refuseIf(!inside, "has a point outside of its size; export it again");
                heights[(rows - 1 - (int) points[i + 1]) * columns + (int) points[i]] = points[i + 2];
            }
            return heights;
        });
        return List.of(wyko(values, samples));
    }

    /**
     * Reads .dat files by Zygo's MetroPro: big-endian fields, intensities, then phases from the top row. A height is phase * scale *
     * obliquity * wavelength / steps of a wavelength. Source: Zygo, "MetroPro Reference Guide", "Data format".
     */
    static List<ScanChannel> metroPro(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(6, ByteOrder.BIG_ENDIAN);
        long start = cursor.unsigned32();
        cursor.at(52);
        start += 2L * cursor.unsigned16() * cursor.unsigned16() * cursor.unsigned16();
        cursor.at(68);
        int columns = cursor.unsigned16();
        int rows = cursor.unsigned16();
        double scale = cursor.at(164).float32() * cursor.float32();
        double obliquity = cursor.at(176).float32();
        double pitch = cursor.at(184).float32();
        int resolution = cursor.at(218).unsigned16();
        ScanException.refuseIf(
                resolution >= ZYGO_STEPS.length, "has phases of the unknown kind " + resolution + "; export it again");
        boolean inverted = cursor.at(232).int16() != 0;
        double factor = (inverted ? -1 : 1) * scale * obliquity / ZYGO_STEPS[resolution];
        Samples samples = Samples.of(file, start, columns, rows, SampleType.SIGNED_32, ByteOrder.BIG_ENDIAN)
                .map(sample -> sample < ZYGO_MISSING ? factor * sample : Double.NaN);
        Extent extent = pitch > 0 ? Extent.ofPitches(pitch, pitch, "m", samples) : Extent.UNKNOWN;
        return List.of(new ScanChannel("Height", samples, extent, "m"));
    }

    /** The format has no mark: two equal sizes, and a file that holds as many samples. */
    static boolean isSensofar(ScanBytes file) throws IOException {
        if (file.size() < SENSOFAR_HEADER + 8) {
            return false;
        }
        ScanBytes.Cursor cursor = file.cursor(388, ByteOrder.LITTLE_ENDIAN);
        long rows = cursor.unsigned32();
        long columns = cursor.unsigned32();
        boolean measured = cursor.at(404).float32() > 0 && cursor.float32() > 0;
        return rows > 0
                && columns > 0
                && measured
                && cursor.at(428).int32() == SENSOFAR_TOPOGRAPHY
                && cursor.at(SENSOFAR_HEADER).unsigned32() == rows
                && cursor.unsigned32() == columns
                && rows * columns <= (file.size() - cursor.position()) / Float.BYTES;
    }

    /** Reads .plu files by Sensofar: pitches and heights in micrometers, layers from the top row, with pictures of 24 bits after each. */
    static List<ScanChannel> sensofar(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(404, ByteOrder.LITTLE_ENDIAN);
        double pitchX = cursor.float32();
        double pitchY = cursor.float32();
        int layers = Math.max(1, cursor.at(SENSOFAR_LAYERS).unsignedByte());
        int pictures = cursor.at(SENSOFAR_LAYERS + 3).unsignedByte();
        cursor.at(SENSOFAR_HEADER);
        List<ScanChannel> channels = new ArrayList<>();
        for (int layer = 1; layer <= Math.min(layers, MOST_LAYERS); layer++) {
            int rows = cursor.int32();
            int columns = cursor.int32();
            Samples samples = Samples.of(file, cursor.position(), columns, rows, SampleType.FLOAT_32)
                    .withMissing(SENSOFAR_MISSING);
            Extent extent = Extent.ofPitches(pitchX, pitchY, "um", samples);
            channels.add(new ScanChannel(layers > 1 ? "Height " + layer : "Height", samples, extent, "um"));
            cursor.skip(samples.count() * (Float.BYTES + 3L * pictures) + 2 * Float.BYTES);
        }
        return channels;
    }

    /**
     * Reads .al3d files by Alicona: tags of 20 and 30 characters, then a depth image in meters from the top row, whose rows take multiples of
     * eight bytes.
     */
    static List<ScanChannel> alicona(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(17, ByteOrder.LITTLE_ENDIAN);
        Header tags = new Header();
        for (int i = 0; i < 2 || i < 2 + Math.min(MOST_TAGS, tags.count("TagCount")); i++) {
            String key = cursor.text(ALICONA_KEY);
            tags.put(key, cursor.text(ALICONA_VALUE));
            cursor.skip(2);
        }
        int columns = tags.count("Cols");
        int rows = tags.count("Rows");
        int padded = columns + columns % 2;
        double mark = tags.find("InvalidPixelValue")
                .flatMap(Header.Quantity::of)
                .map(Header.Quantity::value)
                .orElse(Double.NaN);
        Samples stored = Samples.of(file, tags.count("DepthImageOffset"), padded, rows, SampleType.FLOAT_32);
        Samples samples = new Samples(columns, rows, () -> {
            double[] all = stored.read();
            double[] heights = new double[columns * rows];
            Arrays.setAll(heights, i -> all[i / columns * padded + i % columns]);
            return heights;
        });
        Samples heights = samples.map(
                sample -> Math.abs(sample - mark) <= ALICONA_ROUNDING * Math.abs(mark) ? Double.NaN : sample);
        Extent extent = Extent.ofPitches(tags.number("PixelSizeXMeter"), tags.number("PixelSizeYMeter"), "m", samples);
        return List.of(new ScanChannel("Height", heights, extent, "m"));
    }

    /** Reads .vk3 and .vk4 files by Keyence: a table of offsets, settings with all scales in picometers, up to three height images. */
    static List<ScanChannel> keyence(ScanBytes file) throws IOException {
        ScanException.refuseIf(
                file.startsWith("VK6", "VK7"),
                "is a packed file of a newer Keyence; export its heights as text or .vk4");
        ScanBytes.Cursor cursor = file.cursor(0, ByteOrder.LITTLE_ENDIAN);
        cursor.at(KEYENCE_PITCH + (file.startsWith("VK3") ? 80 : 84));
        double pitchX = cursor.unsigned32();
        double pitchY = cursor.unsigned32();
        double step = cursor.unsigned32();
        List<ScanChannel> channels = new ArrayList<>();
        for (int image = 0; image < KEYENCE_IMAGES; image++) {
            long start =
                    cursor.at(KEYENCE_HEIGHT_OFFSETS + Integer.BYTES * image).unsigned32();
            if (start > 0) {
                int columns = cursor.at(start).int32();
                int rows = cursor.int32();
                SampleType type = SampleType.of(KEYENCE_TYPES, cursor.int32());
                ScanException.refuseIf(cursor.int32() != 0, "has packed heights; save it without compression");
                cursor.skip(3 * Integer.BYTES + KEYENCE_PALETTE);
                Samples samples =
                        Samples.of(file, cursor.position(), columns, rows, type).scale(step, 0);
                Extent extent = Extent.ofPitches(pitchX, pitchY, "pm", samples);
                channels.add(new ScanChannel(image == 0 ? "Height" : "Height " + (image + 1), samples, extent, "pm"));
            }
        }
        return channels;
    }

    static boolean isBcr(ScanBytes file) throws IOException {
        return bcrEncoding(file).isPresent();
    }

    private static Optional<Charset> bcrEncoding(ScanBytes file) throws IOException {
        byte[] head = file.head(2 * BCR.length() + 2);
        return Stream.of(StandardCharsets.ISO_8859_1, StandardCharsets.UTF_16LE, StandardCharsets.UTF_16)
                .filter(charset -> new String(head, charset).startsWith(BCR))
                .findFirst();
    }

    /**
     * Reads the exchange format BCR-STM (.bcr, integers) and BCRF (floats): a text header of {@code headersize} characters, then samples
     * from the top row. Source: Image Metrology, "BCR-STM file format".
     */
    static List<ScanChannel> bcr(ScanBytes file) throws IOException {
        Charset charset = bcrEncoding(file).orElseThrow();
        int perCharacter = charset.equals(StandardCharsets.ISO_8859_1) ? 1 : 2;
        Header probe = Header.of(new String(file.head(BCR_HEADER * perCharacter), charset), '=');
        int size = perCharacter * (probe.has("headersize") ? probe.count("headersize") : BCR_HEADER);
        Header values = Header.of(new String(file.read(0, size).array(), charset), '=');
        boolean floats = values.text("fileformat", "").startsWith("bcrf");
        ByteOrder order = values.number("intelmode", 1) != 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        int columns = values.count("xpixels");
        int rows = values.count("ypixels");
        Samples stored =
                Samples.of(file, size, columns, rows, floats ? SampleType.FLOAT_32 : SampleType.SIGNED_16, order);
        double missing = floats ? BCR_MISSING_FLOAT : Short.MAX_VALUE;
        double factor = floats ? 1 : values.number("bit2nm", 1);
        Samples heights = stored.map(sample -> sample < missing ? factor * sample : Double.NaN);
        Extent extent = new Extent(
                Header.Quantity.of(values.text("xlength", ""))
                        .flatMap(length -> length.meters(values.text("xunit", "nm"))),
                Header.Quantity.of(values.text("ylength", ""))
                        .flatMap(length -> length.meters(values.text("yunit", "nm"))),
                1);
        return List.of(new ScanChannel("Height", heights, extent, values.text("zunit", "nm")));
    }
}
