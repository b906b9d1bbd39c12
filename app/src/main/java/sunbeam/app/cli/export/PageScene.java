package sunbeam.app.cli.export;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.zip.Deflater;
import javax.imageio.ImageIO;
import jrtr.gl.RenderContext;
import sunbeam.app.files.output.ExrFile;
import sunbeam.app.render.PartSum;
import sunbeam.app.render.SceneLoader.LoadingScene;
import sunbeam.app.render.SceneSession;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.render.WebScene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.patch.Patch;

/**
 * A scene in the elements of page.html.
 *
 * @param title of the scene; may be blank
 * @param exposure that of {@code render} at its default size
 * @param elements scripts that hold the compressed mesh and the textures
 * @param notes a line for each texture that is reduced
 */
record PageScene(
        String title, Patch patch, double exposure, Map<String, Object> fields, String elements, List<String> notes) {
    // Share of a page that mesh and textures may take, so that the table has the rest.
    private static final double MOST_SHARE = 0.75;
    // In texels, as telephones hold.
    private static final int LARGEST_SIDE = 4096;
    // Larger pictures are JPEG.
    private static final int LARGEST_PNG = 300_000;
    private static final int[] OPAQUE = {0, 1, 2};
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    /** Loads a scene, and measures its exposure with OpenGL. */
    static PageScene of(LoadingScene loading, String name, long mostBytes) {
        try (RenderContext context = loading.offscreen()) {
            var sessions = loading.upload(context);
            try {
                SceneSession session = sessions.get(0);
                double exposure = new PartSum(sessions)
                        .exposure(session.data().scene(), WIDTH, HEIGHT, TimedTiles.large(), () -> false)
                        .orElseThrow();
                WebScene scene = WebScene.of(session.data(), exposure);
                PageScene page = new PageScene(
                        session.data().scene().get(SceneSettings.TITLE),
                        session.data().patch(),
                        exposure,
                        scene.fields(),
                        elements(scene),
                        notes(scene));
                UsageException.throwIf(
                        page.bytes() > MOST_SHARE * mostBytes,
                        "scene " + name + " takes " + ByteSize.format(page.bytes()) + " of a page of "
                                + ByteSize.format(mostBytes) + ", its mesh of "
                                + session.data().shape().whole().triangles()
                                + " triangles and its textures; give a simpler mesh or smaller textures, or a larger --size");
                return page;
            } finally {
                sessions.forEach(SceneSession::close);
            }
        }
    }

    long bytes() {
        return elements.length();
    }

    private static List<String> notes(WebScene scene) {
        return new TreeMap<>(scene.textures())
                .entrySet().stream()
                        .filter(texture -> side(texture.getValue()) > LARGEST_SIDE)
                        .map(texture ->
                                texture.getKey() + " of " + texture.getValue().width() + " x "
                                        + texture.getValue().height() + " texels is reduced to a longer side of "
                                        + LARGEST_SIDE + ", as graphics cards of telephones hold")
                        .toList();
    }

    private static int side(BodyTexture texture) {
        return Math.max(texture.width(), texture.height());
    }

    private static String elements(WebScene scene) {
        String mesh = Base64.getEncoder().encodeToString(ExrFile.deflated(scene.columns(), Deflater.BEST_COMPRESSION));
        return "<script type=\"text/plain\" id=\"mesh\">" + mesh + "</script>\n"
                + new TreeMap<>(scene.textures())
                        .entrySet().stream()
                                .map(texture -> element(texture.getKey(), texture.getValue()))
                                .collect(Collectors.joining());
    }

    /** Returns an element with a texture: as PNG if that is small or alpha has values between, else as JPEG and, for alpha, a mask. */
    static String element(String id, BodyTexture texture) {
        boolean isOpaque = true;
        boolean isBinary = true;
        for (int i = 3; i < texture.rgba().length; i += 4) {
            isOpaque &= texture.rgba()[i] == -1;
            isBinary &= texture.rgba()[i] == -1 || texture.rgba()[i] == 0;
        }
        int[] all = {0, 1, 2, 3};
        String whole = address(image(texture, isOpaque ? OPAQUE : all), "png");
        boolean isMasked = isBinary && whole.length() > LARGEST_PNG;
        String mask =
                isMasked && !isOpaque ? "data-mask=\"" + address(image(texture, new int[] {3}), "png") + "\" " : "";
        return "<script type=\"text/plain\" " + mask + "id=\"" + id + "\">"
                + (isMasked ? address(image(texture, OPAQUE), "jpeg") : whole) + "</script>\n";
    }

    /** Returns some channels of a texture: one, three or four. */
    private static BufferedImage image(BodyTexture texture, int[] channels) {
        int type = Map.of(
                        1, BufferedImage.TYPE_BYTE_GRAY,
                        3, BufferedImage.TYPE_3BYTE_BGR,
                        4, BufferedImage.TYPE_4BYTE_ABGR)
                .get(channels.length);
        BufferedImage image = new BufferedImage(texture.width(), texture.height(), type);
        byte[] bytes = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
        for (int i = 0; i < bytes.length; i++) {
            int channel = channels[channels.length - 1 - i % channels.length];
            bytes[i] = texture.rgba()[4 * (i / channels.length) + channel];
        }
        return fitting(image);
    }

    private static BufferedImage fitting(BufferedImage image) {
        double scale = LARGEST_SIDE / (double) Math.max(image.getWidth(), image.getHeight());
        if (scale >= 1) {
            return image;
        }
        int width = (int) Math.max(1, Math.round(scale * image.getWidth()));
        int height = (int) Math.max(1, Math.round(scale * image.getHeight()));
        BufferedImage small = new BufferedImage(width, height, image.getType());
        small.createGraphics()
                .drawImage(image.getScaledInstance(width, height, Image.SCALE_AREA_AVERAGING), 0, 0, null);
        return small;
    }

    /** Returns an image as an address that holds it. */
    static String address(BufferedImage image, String format) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, format, bytes);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return "data:image/" + format + ";base64," + Base64.getEncoder().encodeToString(bytes.toByteArray());
    }
}
