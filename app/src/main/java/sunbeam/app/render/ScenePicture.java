package sunbeam.app.render;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.picture.LinearPicture;

/**
 * A scene's picture or a tile of one, in linear colors before exposure.
 *
 * @param rgba {@code height * width * 4}, row 0 on top: CIE X, Y, Z, each times opacity, and the opacity: 1 on the mesh, below 1 on the
 *     ground, else 0; in a {@link #reduced} pixel the mesh's coverage. Shared, not copied
 */
public record ScenePicture(int width, int height, float[] rgba) {
    private static final int CHANNELS = 4;

    public static ScenePicture empty(int width, int height) {
        return new ScenePicture(
                width, height, new float[Math.multiplyExact(CHANNELS, Math.multiplyExact(width, height))]);
    }

    /** Adds pictures to the first and returns it. A color missing in one picture is missing in the sum. */
    static ScenePicture sum(List<ScenePicture> pictures) {
        float[] sum = pictures.get(0).rgba;
        for (ScenePicture other : pictures.subList(1, pictures.size())) {
            for (int i = 0; i < sum.length; i++) {
                sum[i] = i % CHANNELS == CHANNELS - 1 ? Math.min(sum[i], other.rgba[i]) : sum[i] + other.rgba[i];
            }
        }
        return pictures.get(0);
    }

    /** Puts the pixels of further pictures that show the mesh into the first, and returns it. No pixel shows the mesh in two. */
    static ScenePicture joined(List<ScenePicture> pictures) {
        ScenePicture first = pictures.get(0);
        for (ScenePicture other : pictures.subList(1, pictures.size())) {
            for (int i = 0; i < first.rgba.length; i += CHANNELS) {
                // The ground may be in a later picture.
                if (other.isMesh(i) || first.rgba[i + 3] == 0) {
                    System.arraycopy(other.rgba, i, first.rgba, i, CHANNELS);
                }
            }
        }
        return first;
    }

    /** Copies a tile into this picture, its top left pixel to column x and row y. */
    public void put(ScenePicture part, int x, int y) {
        for (int row = 0; row < part.height; row++) {
            int to = CHANNELS * ((y + row) * width + x);
            System.arraycopy(part.rgba, CHANNELS * row * part.width, rgba, to, CHANNELS * part.width);
        }
    }

    /** Returns means of {@code factor x factor} samples, without the ground, which counts as background. */
    public ScenePicture reduced(int factor) {
        ScenePicture small = empty(width / factor, height / factor);
        for (int row = 0; row < small.height; row++) {
            for (int column = 0; column < small.width; column++) {
                small.setMean(row * small.width + column, this, factor * (row * width + column), factor, factor);
            }
        }
        return small;
    }

    /** Averages a rectangle of samples, as {@link #reduced}. */
    void setMean(int pixel, ScenePicture samples, int corner, int across, int down) {
        int to = CHANNELS * pixel;
        Arrays.fill(rgba, to, to + CHANNELS, 0);
        float share = 1f / (across * down);
        for (int y = 0; y < down; y++) {
            int begin = CHANNELS * (corner + y * samples.width);
            for (int from = begin; from < begin + CHANNELS * across; from += CHANNELS) {
                if (samples.isMesh(from)) {
                    for (int c = 0; c < CHANNELS; c++) {
                        rgba[to + c] += share * samples.rgba[from + c];
                    }
                }
            }
        }
    }

    private boolean isMesh(int from) {
        return rgba[from + 3] == 1;
    }

    /**
     * Enlarges this picture by bilinear interpolation between its pixels of the mesh; each becomes the top left one of a square of {@code
     * stride x stride}.
     *
     * @param shape full-resolution picture whose pixels show the mesh
     * @param white luminance to which brighter pixels are dimmed, so that interpolation does not spread a glint
     */
    public ScenePicture enlarged(int stride, ScenePicture shape, double white) {
        ScenePicture whole = empty(shape.width, shape.height);
        IntStream.range(0, whole.height).parallel().forEach(y -> {
            for (int x = 0; x < whole.width; x++) {
                int to = CHANNELS * (y * whole.width + x);
                if (shape.isMesh(to)) {
                    interpolate((float) x / stride, (float) y / stride, (float) white, whole.rgba, to);
                    whole.rgba[to + 3] = shape.rgba[to + 3];
                }
            }
        });
        return whole;
    }

    private void interpolate(float column, float row, float white, float[] result, int to) {
        float sum = 0;
        for (int corner = 0; corner < 4; corner++) {
            int x = Math.min(width - 1, (int) column + corner % 2);
            int y = Math.min(height - 1, (int) row + corner / 2);
            int from = CHANNELS * (y * width + x);
            float weight =
                    isMesh(from) ? (1 - Math.min(1, Math.abs(column - x))) * (1 - Math.min(1, Math.abs(row - y))) : 0;
            float dimmed = weight * Math.min(1, white / rgba[from + 1]);
            for (int c = 0; c < 3; c++) {
                result[to + c] += dimmed * rgba[from + c];
            }
            sum += weight;
        }
        for (int c = 0; c < 3; c++) {
            result[to + c] = sum > 0 ? result[to + c] / sum : 0;
        }
    }

    /** Linear XYZ of the mesh: means over the covered part of each pixel, NaN without mesh. */
    public LinearPicture linear() {
        float[] xyz = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            float coverage = rgba[CHANNELS * i + 3];
            for (int c = 0; c < 3; c++) {
                xyz[3 * i + c] = coverage > 0 ? rgba[CHANNELS * i + c] / coverage : Float.NaN;
            }
        }
        return new LinearPicture(width, height, xyz);
    }
}
