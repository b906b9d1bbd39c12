package sunbeam.app.fuzz;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import javax.imageio.ImageIO;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.files.cache.TileFile;
import sunbeam.app.files.output.PngWriter;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.LevelBaking.CachedTiles;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTablesFile;
import sunbeam.precompute.plan.ShaderTablesFile.TableLabel;
import sunbeam.precompute.plan.TableArray;

final class Seeds {
    /** Of the shader tables. */
    static final String KEY = "full|a surface|a plan";

    private static final int SIDE = 8;

    private Seeds() {}

    private static BufferedImage picture(int type) {
        BufferedImage image = new BufferedImage(SIDE, SIDE, type);
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            image.setRGB(pixel % SIDE, pixel / SIDE, 0x030303 * pixel);
        }
        return image;
    }

    static byte[] image(String format) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(picture(BufferedImage.TYPE_INT_RGB), format, bytes);
        return bytes.toByteArray();
    }

    static byte[] pictureWithText() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(
                bytes, picture(BufferedImage.TYPE_INT_RGB), Map.of("Title", "seed", "Patch", "\u86c7 of 65 \u00b5m"));
        return bytes.toByteArray();
    }

    /** Gwyddion Simple Field: text, zeros up to a multiple of four, then float32, little-endian. */
    static byte[] gsf() {
        String header = """
                Gwyddion Simple Field 1.0
                XRes = 4
                YRes = 3
                XReal = 1e-6
                YReal = 7.5e-7
                ZUnits = m
                XYUnits = m
                Title = seed
                """;
        int length = header.length() / 4 * 4 + 4;
        ByteBuffer bytes = ByteBuffer.allocate(length + 4 * 4 * 3).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(header.getBytes(StandardCharsets.US_ASCII)).position(length);
        for (int sample = 0; sample < 4 * 3; sample++) {
            bytes.putFloat(sample * 1e-9f);
        }
        return bytes.array();
    }

    static byte[] numberText(String header) {
        return (header + "1.0 2.0 3.0\n4.0 5.5 6e-1\n7. 8 nan\n").getBytes(StandardCharsets.UTF_8);
    }

    static byte[] shaderTables() throws IOException {
        ArrayLayout layout = ArrayLayout.layered("terms", 3, 2, 2, 2);
        ShaderTables tables = new ShaderTables.Builder("full_grid")
                .define("TAPS", 4)
                .reals("scale", 0.1)
                .integers("first", -7, 9)
                .array(TableArray.computed(layout, number -> new float[layout.floatsPerLayer()]))
                .build(16e-6, 0.04);
        return written(file -> ShaderTablesFile.write(file, KEY, new TableLabel("", ""), tables));
    }

    static CachedTiles pages(Path file) {
        CacheFolder folder = new CacheFolder(file.getParent(), "");
        return TileFile.of(folder, file, KEY, NumberFormat.HALF, new TableLabel("", ""), warning -> {});
    }

    static byte[] pages() throws IOException {
        return written(file -> {
            try (CachedTiles kept = pages(file)) {
                kept.keep(0, Map.of(3, new byte[NumberFormat.HALF.bytes() * LevelBaking.TILE_NUMBERS]));
                kept.keep(1, Map.of(2, new byte[NumberFormat.HALF.bytes() * LevelBaking.TILE_NUMBERS]));
            }
        });
    }

    private interface FileWriter {
        void write(Path file);
    }

    private static byte[] written(FileWriter writer) throws IOException {
        Path folder = Files.createTempDirectory("sunbeam-seed");
        Path file = folder.resolve("file");
        writer.write(file);
        byte[] content = Files.readAllBytes(file);
        Files.delete(file);
        Files.delete(folder);
        return content;
    }
}
