package sunbeam.app.scene.mesh;

import static sunbeam.app.scene.texture.ScaleRelief.HEAD_SHARE;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.ScaleRelief;
import sunbeam.app.scene.texture.Scales;
import sunbeam.precompute.color.Srgb;

/**
 * Skin of a mesh for other programs (shaders/include/relief.glsl): sRGB times lightness, and normals in the tangent frame, -1 to 1 as 0 to
 * 255.
 */
public record SkinMaps(BufferedImage albedo, Optional<BufferedImage> normals) {
    // A scale of the snake is about 27 texels long and 36 wide.
    private static final int WIDTH = 8192;
    private static final int HEIGHT = 512;
    // Points in a texel, as dense as the texels of the relief texture.
    private static final int POINTS_ALONG = 5;
    private static final int POINTS_ACROSS = 2;
    private static final double[] SMOOTH = {0, 0, 1, 0};
    // PALE of shaders/include/relief.glsl, linear.
    private static final double[] PALE = {0.61, 0.52, 0.39};

    public static SkinMaps of(Body body) {
        return body.scales() == Scales.NONE
                ? of(body, body.colors().width(), body.colors().height())
                : of(body, WIDTH, HEIGHT);
    }

    static SkinMaps of(Body body, int width, int height) {
        boolean isSmooth = body.scales() == Scales.NONE;
        Supplier<BufferedImage> picture = () -> new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        SkinMaps maps = new SkinMaps(picture.get(), isSmooth ? Optional.empty() : Optional.of(picture.get()));
        double reliefsPerU = body.scales().perUnit() / ScaleRelief.SCALES_ALONG;
        IntStream.range(0, height).parallel().forEach(row -> {
            int[] albedo = new int[width];
            int[] normals = new int[width];
            double v = 1 - (row + 0.5) / height;
            for (int column = 0; column < width; column++) {
                double u = (column + 0.5) / width;
                double[] relief =
                        isSmooth ? SMOOTH : relief(body.relief(), reliefsPerU, u, v, 1.0 / width, 1.0 / height);
                albedo[column] = rgb(body.colors().color(byteIndex(body.colors(), u, v) / 4), relief[2], relief[3]);
                normals[column] = normal(relief);
            }
            // Rows do not overlap, so threads may write in parallel.
            maps.albedo.setRGB(0, row, width, 1, albedo, 0, width);
            maps.normals.ifPresent(image -> image.setRGB(0, row, width, 1, normals, 0, width));
        });
        return maps;
    }

    /** Returns the first byte's index; u repeats, v is clamped. */
    private static int byteIndex(BodyTexture texture, double u, double v) {
        int column = Math.min(texture.width() - 1, (int) Math.floor((u - Math.floor(u)) * texture.width()));
        int row = Math.max(0, Math.min(texture.height() - 1, (int) Math.floor((1 - v) * texture.height())));
        return 4 * (row * texture.width() + column);
    }

    /** Returns means over a texel of size (du, dv): slopes along u and v, lightness, share of pale pigment. */
    private static double[] relief(BodyTexture relief, double reliefsPerU, double u, double v, double du, double dv) {
        // Both reliefs fade out over 1/120 of u where the head ends.
        double share = Math.min(1, 120 * Math.abs(u - ScaleRelief.BEGIN));
        double[] sum = new double[4];
        byte[] rgba = relief.rgba();
        for (int i = 0; i < POINTS_ALONG; i++) {
            for (int j = 0; j < POINTS_ACROSS; j++) {
                double along = u + ((i + 0.5) / POINTS_ALONG - 0.5) * du;
                double across = v + ((j + 0.5) / POINTS_ACROSS - 0.5) * dv;
                double inside = Math.max(0, Math.min(1, across));
                int at = u < ScaleRelief.BEGIN
                        ? byteIndex(relief, along / ScaleRelief.BEGIN, HEAD_SHARE * inside)
                        : byteIndex(relief, reliefsPerU * along, HEAD_SHARE + (1 - HEAD_SHARE) * inside);
                sum[0] += (Byte.toUnsignedInt(rgba[at]) - 128) / 127.0;
                sum[1] += (Byte.toUnsignedInt(rgba[at + 1]) - 128) / 127.0;
                sum[2] += Byte.toUnsignedInt(rgba[at + 3]) / 255.0;
                sum[3] += Byte.toUnsignedInt(rgba[at + 2]) / 255.0;
            }
        }
        double each = 1.0 / (POINTS_ALONG * POINTS_ACROSS);
        double slope = share * ScaleRelief.STEEPEST * each;
        double light = 1 + share * (ScaleRelief.LIGHTEST * each * sum[2] - 1);
        return new double[] {slope * sum[0], slope * sum[1], light, share * each * sum[3]};
    }

    private static int rgb(int color, double light, double pale) {
        if (light == 1 && pale == 0) {
            return color;
        }
        int rgb = 0;
        for (int c = 0; c < 3; c++) {
            double linear = light * ((1 - pale) * Srgb.linear(color >> (16 - 8 * c) & 0xff) + pale * PALE[c]);
            rgb = rgb << 8 | Srgb.channel(linear);
        }
        return rgb;
    }

    private static int normal(double[] relief) {
        double length = Math.sqrt(1 + relief[0] * relief[0] + relief[1] * relief[1]);
        return code(-relief[0] / length) << 16 | code(-relief[1] / length) << 8 | code(1 / length);
    }

    private static int code(double component) {
        return (int) Math.round(255 * (0.5 + 0.5 * component));
    }
}
