package sunbeam.app.fuzz;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.imageio.ImageIO;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.files.cache.TileFile;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.MeshFiles;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchLoader.HeightCache;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTablesFile;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.TableLabel;
import sunbeam.precompute.setting.Choices;

/** Everything of Sunbeam's that reads a file which may have come from anywhere. */
enum FuzzedReader {
    /** Images, scans and text with heights, with the scale on the command line. */
    HEIGHTS(
            "heights",
            file -> load(choices(file).with(PatchSettings.WIDTH, 10e-6).with(PatchSettings.MAX_HEIGHT, 300e-9))),
    /** Scans that bring their own scale. */
    SCAN("scan", file -> load(choices(file))),
    /** Descriptors, with a good image beside them. */
    DESCRIPTOR("patch.json", file -> {
        Files.write(file.resolveSibling("scan.png"), image("png"));
        load(choices(file));
    }),
    SCENE("scene.json", Scenes::read),
    DIRECTIONS("directions.csv", file -> DirectionList.read(file).pairs()),
    /** OBJ, PLY and glTF, which go by how they begin. */
    MESH("mesh", file -> MeshSource.of(file.toString()).load()),
    TEXTURE("texture", file -> BodyTexture.load(file.toString(), BlobCache.NONE)),
    PICTURE("picture.png", PngText::read),
    SHADER_TABLES("shader.tables", file -> ShaderTablesFile.read(file, FuzzedReader.KEY)),
    PAGES("one.tiles", file -> {
        new CacheFolder.Entry(file, Files.size(file), Instant.EPOCH).label();
        BitSet pages = new BitSet();
        pages.set(0, 8);
        try (CachedTiles kept = pages(file)) {
            for (int level = 0; level < 3; level++) {
                kept.read(level, pages);
            }
            kept.keep(2, Map.of(7, new byte[NumberFormat.HALF.bytes() * LevelBaking.TILE_NUMBERS]));
        }
    });

    private final String fileName;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final Reader reader;

    private interface Reader {
        void read(Path file) throws IOException;
    }

    FuzzedReader(String fileName, Reader reader) {
        this.fileName = fileName;
        this.reader = reader;
    }

    void read(Path file) throws IOException {
        reader.read(file);
    }

    private static void load(Choices choices) {
        PatchLoader.load(new PatchRequest(choices), HeightCache.NONE);
    }

    private static Choices choices(Path file) {
        return Choices.at(OptionOrigin.INSTANCE).with(PatchSettings.PATCH, file.toString());
    }

    String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static FuzzedReader of(String label) {
        return valueOf(label.toUpperCase(Locale.ROOT).replace('-', '_'));
    }

    /** What the file is called; only JSON and CSV go by their names. */
    String fileName() {
        return fileName;
    }

    /** Folder of the inputs that are kept, under {@code src/test/resources/sunbeam/app/fuzz}. */
    String corpus() {
        return this == SCAN ? HEIGHTS.label() : label();
    }

    /** Good inputs, from which mutations start. */
    List<byte[]> seeds() throws IOException {
        return switch (this) {
            case HEIGHTS -> List.of(image("png"), image("bmp"), image("tiff"), numberText(""));
            case SCAN -> List.of(gsf(), numberText("# Channel: z\n# Width: 3 um\n# Height: 3 um\n# Value units: nm\n"));
            case TEXTURE -> List.of(image("png"), image("jpeg"), image("gif"), image("bmp"), image("tiff"));
            case PICTURE -> List.of(pictureWithText());
            case DESCRIPTOR -> List.of(text("""
                    {"heights": "scan.png", "width": "10 um", "maxHeight": "300 nm", "levelling": "plane"}
                    """));
            case SCENE -> List.of(text("""
                    {"mesh": "snake", "patch": {"file": "elaphe-like"}, "texture": "none", "rotatePatch": "30 deg",
                     "camera": {"position": ["10 cm", "-20 cm", "15 cm"], "lookAt": ["0 m", "0 m", "0 m"],
                                "fieldOfView": "30 deg"},
                     "light": {"direction": [0, 0, 2], "intensity": 1}, "exposure": 2, "background": "#102030",
                     "plan": {"tolerance": 0.01}, "weights": {"diffraction": 20}, "orientation": [0, 0, 0, 1]}
                    """));
            case DIRECTIONS ->
                List.of(text("theta_i,phi_i,theta_r,phi_r,wavelength\n0,0,10,180,550\n\"30\",1e1,-0.0,5,400\n"));
            case MESH ->
                List.of(
                        MeshFiles.ply(BuiltInMeshes.create("plane"), "ascii"),
                        MeshFiles.ply(BuiltInMeshes.create("plane"), "binary_little_endian"),
                        MeshFiles.ply(BuiltInMeshes.create("plane"), "binary_big_endian"),
                        MeshFiles.glb(BuiltInMeshes.create("plane")),
                        text(MeshFiles.gltf(BuiltInMeshes.create("plane"))),
                        text("""
                    v 0 0 0
                    v 1 0 0
                    v 1 1 0
                    v 0 1 .5
                    vt 0 0
                    vt 1 0
                    vn 0 0 1
                    f 1/1/1 2/2/1 3/1/1 4/2/1
                    f -1 -2 -3
                    f 1//1 2//1 \\
                    4//1
                    """));
            case SHADER_TABLES -> List.of(shaderTables());
            case PAGES -> List.of(pages());
        };
    }

    private static byte[] text(String content) {
        return content.getBytes(StandardCharsets.UTF_8);
    }

    /** Of the shader tables. */
    private static final String KEY = "full|a surface|a plan";

    private static final int SIDE = 8;

    private static BufferedImage picture(int type) {
        BufferedImage image = new BufferedImage(SIDE, SIDE, type);
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            image.setRGB(pixel % SIDE, pixel / SIDE, 0x030303 * pixel);
        }
        return image;
    }

    private static byte[] image(String format) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(picture(BufferedImage.TYPE_INT_RGB), format, bytes);
        return bytes.toByteArray();
    }

    private static byte[] pictureWithText() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(
                bytes, picture(BufferedImage.TYPE_INT_RGB), Map.of("Title", "seed", "Patch", "\u86c7 of 65 \u00b5m"));
        return bytes.toByteArray();
    }

    /** Gwyddion Simple Field: text, zeros up to a multiple of four, then float32, little-endian. */
    private static byte[] gsf() {
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

    private static byte[] numberText(String header) {
        return (header + "1.0 2.0 3.0\n4.0 5.5 6e-1\n7. 8 nan\n").getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] shaderTables() throws IOException {
        ArrayLayout layout = ArrayLayout.layered("terms", 3, 2, 2, 2);
        ShaderTables tables = new ShaderTables.Builder("full_grid")
                .define("TAPS", 4)
                .reals("scale", 0.1)
                .integers("first", -7, 9)
                .array(TableArray.computed(layout, number -> new float[layout.floatsPerLayer()]))
                .build(16e-6, 0.04);
        return written(file -> ShaderTablesFile.write(file, KEY, new TableLabel("", ""), tables));
    }

    private static CachedTiles pages(Path file) {
        CacheFolder folder = new CacheFolder(file.getParent(), "");
        return TileFile.of(folder, file, KEY, NumberFormat.HALF, new TableLabel("", ""), warning -> {});
    }

    private static byte[] pages() throws IOException {
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
