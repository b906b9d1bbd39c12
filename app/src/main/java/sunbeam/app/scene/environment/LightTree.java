package sunbeam.app.scene.environment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import jrtr.scene.Light;
import org.joml.Vector3d;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * A map of radiance divided into regions: again and again the region whose luminance times variance of directions is largest is halved.
 * Regions are rectangles of the sphere's equal-area octahedral map (Clarberg 2008), so that equal ones form a lattice, over which their
 * lights add up to an even radiance. The regions of a coarse division are sums of those of a finer one.
 */
public final class LightTree {
    /** Most regions of a picture. */
    public static final int MOST = 2048;

    /** Most regions, with which certificates compare. */
    public static final int FINEST = 8 * MOST;

    // Halvings of the octahedral map along either axis; a pixel of the largest map is wider.
    private static final int BITS = 14;

    private final RadianceMap map;
    // Each pixel has three components of its direction, and its luminance times its solid angle.
    private final float[] directions;
    private final float[] luminances;
    // Pixels with light in the order of Morton's curve over the octahedral map: those of a region follow one another.
    private final int[] pixels;
    private final int[] codes;
    private final Region root;

    /**
     * Neighboring regions, each as one light: its radiance is the irradiance across its direction over pi, that of a white surface.
     *
     * @param deviation standard deviation of the directions of all of them along either axis, radians
     */
    public record Group(List<Light> lights, double deviation) {}

    public static double luminance(Light light) {
        Vector3fc color = light.radiance();
        return RadianceMap.luminance(color.x(), color.y(), color.z());
    }

    /** Luminance of a white surface that faces the brightest side of lights, without shadows; 0 without lights. */
    public static double white(List<Light> lights) {
        return lights.stream()
                .mapToDouble(facing -> lights.stream()
                        .mapToDouble(light ->
                                luminance(light) * Math.max(0, light.towards().dot(facing.towards())))
                        .sum())
                .max()
                .orElse(0);
    }

    private static final class Region {
        final int first;
        final int end;
        // Number of halvings of the map that led here.
        final int depth;
        Light light;
        double priority;
        // Number of regions when this one is halved.
        int step = Integer.MAX_VALUE;
        Region left;
        Region right;

        Region(int first, int end, int depth) {
            this.first = first;
            this.end = end;
            this.depth = depth;
        }
    }

    private LightTree(RadianceMap map) {
        int count = map.height() * map.width();
        this.map = map;
        this.directions = new float[3 * count];
        this.luminances = new float[count];
        IntStream.range(0, map.height()).parallel().forEach(this::prepare);
        long[] ordered = IntStream.range(0, count)
                .filter(i -> luminances[i] > 0)
                .mapToLong(i -> (long) code(i) << 32 | i)
                .sorted()
                .toArray();
        this.pixels = Arrays.stream(ordered).mapToInt(packed -> (int) packed).toArray();
        this.codes =
                Arrays.stream(ordered).mapToInt(packed -> (int) (packed >> 32)).toArray();
        this.root = measured(new Region(0, pixels.length, 0));
    }

    private void prepare(int row) {
        for (int column = 0; column < map.width(); column++) {
            int pixel = row * map.width() + column;
            Vector3d direction = RadianceMap.direction(map.azimuth(column), map.elevation(row));
            for (int c = 0; c < 3; c++) {
                directions[3 * pixel + c] = (float) direction.get(c);
            }
            luminances[pixel] = (float) (map.luminance(row, column) * map.solidAngle(row));
        }
    }

    /** @param most of its regions */
    static LightTree of(RadianceMap map, int most) {
        LightTree tree = new LightTree(map);
        var largest = new PriorityQueue<Region>(Comparator.comparingDouble(region -> -region.priority));
        largest.add(tree.root);
        while (largest.size() < most && largest.peek().priority > 0) {
            Region region = largest.poll();
            region.step = largest.size() + 1;
            tree.halve(region);
            largest.add(region.left);
            largest.add(region.right);
        }
        return tree;
    }

    /** Returns the position of a pixel on Morton's curve over the octahedral map. */
    private int code(int pixel) {
        double z = directions[3 * pixel + 2];
        double radius = Math.sqrt(1 - Math.min(1, Math.abs(z)));
        double share = Math.atan2(Math.abs(directions[3 * pixel + 1]), Math.abs(directions[3 * pixel])) / (Math.PI / 2);
        double y = z < 0 ? 1 - radius * (1 - share) : radius * share;
        double x = z < 0 ? 1 - radius * share : radius * (1 - share);
        int code = 0;
        int column = step(Math.copySign(x, directions[3 * pixel]));
        int row = step(Math.copySign(y, directions[3 * pixel + 1]));
        for (int bit = BITS - 1; bit >= 0; bit--) {
            code = code << 2 | (column >> bit & 1) << 1 | (row >> bit & 1);
        }
        return code;
    }

    private static int step(double coordinate) {
        return (int) Math.max(0, Math.min((1 << BITS) - 1, (0.5 + 0.5 * coordinate) * (1 << BITS)));
    }

    private Region measured(Region region) {
        Vector3d sum = new Vector3d();
        double[] color = new double[3];
        double luminance = 0;
        double ownVariance = 0;
        for (int i = region.first; i < region.end; i++) {
            int row = pixels[i] / map.width();
            double solidAngle = map.solidAngle(row);
            double share = luminances[pixels[i]];
            int at = 3 * pixels[i];
            sum.add(share * directions[at], share * directions[at + 1], share * directions[at + 2]);
            luminance += share;
            ownVariance += share * solidAngle / 12;
            for (int c = 0; c < 3; c++) {
                color[c] += map.value(row, pixels[i] % map.width(), c) * solidAngle / Math.PI;
            }
        }
        // Half the mean square of the chord to the mean direction. Regions that surround all directions have no mean.
        double length = sum.length() / luminance;
        double variance = Math.max(0, 1 - length) + ownVariance / luminance;
        Vector3d towards = length > 1e-9 ? sum.normalize() : new Vector3d(0, 0, 1);
        Vector3d stretch = stretch(region, towards, luminance);
        region.light = new Light(
                new Vector3f(towards),
                new Vector3f((float) color[0], (float) color[1], (float) color[2]),
                Math.sqrt(Math.max(ownVariance / luminance, variance - stretch.lengthSquared() / 2)),
                new Vector3f(stretch));
        // A single point of the map cannot be halved.
        region.priority = codes[region.first] != codes[region.end - 1] ? luminance * variance : 0;
        return region;
    }

    /** Returns the vector of {@link Light#stretch}. */
    private Vector3d stretch(Region region, Vector3d towards, double luminance) {
        Vector3d across = towards.cross(
                        Math.abs(towards.z) < 0.9 ? new Vector3d(0, 0, 1) : new Vector3d(1, 0, 0), new Vector3d())
                .normalize();
        Vector3d up = towards.cross(across, new Vector3d());
        double difference = 0;
        double mixed = 0;
        for (int i = region.first; i < region.end; i++) {
            int at = 3 * pixels[i];
            double x = across.dot(directions[at], directions[at + 1], directions[at + 2]);
            double y = up.dot(directions[at], directions[at + 1], directions[at + 2]);
            double share = luminances[pixels[i]] / luminance;
            difference += share * (x * x - y * y);
            mixed += share * 2 * x * y;
        }
        double angle = 0.5 * Math.atan2(mixed, difference);
        double root = Math.sqrt(Math.hypot(difference, mixed));
        return across.mul(root * Math.cos(angle)).fma(root * Math.sin(angle), up);
    }

    /** Halves a region at the first of the map's halvings that divides its pixels. */
    private void halve(Region region) {
        int depth = region.depth;
        int at;
        do {
            depth++;
            at = region.first;
            int bit = 1 << (2 * BITS - depth);
            // Before this bit all codes of the region are equal.
            int low = region.first;
            int high = region.end;
            while (low < high) {
                int middle = (low + high) / 2;
                if ((codes[middle] & bit) == 0) {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            at = low;
        } while (at == region.first || at == region.end);
        region.left = measured(new Region(region.first, at, depth));
        region.right = measured(new Region(at, region.end, depth));
    }

    /**
     * Returns lights in groups of neighbors.
     *
     * @param count of lights, at most; a map of few pixels has fewer
     * @param groups of groups, at most
     */
    public List<Group> groups(int count, int groups) {
        List<Group> all = new ArrayList<>();
        visit(root, groups, group -> {
            List<Light> lights = new ArrayList<>();
            visit(group, count, region -> lights.add(region.light));
            all.add(new Group(lights, group.light.deviation()));
        });
        return all;
    }

    /**
     * Returns pixels of the map as {@link #MOST} lights of equal luminance, at equal steps through the luminance of all: a pixel as bright as
     * several steps is several lights.
     */
    public List<Group> pixels(int groups) {
        double step =
                IntStream.of(pixels).mapToDouble(pixel -> luminances[pixel]).sum() / MOST;
        List<Group> all = new ArrayList<>();
        // Luminance up to the next light.
        double[] left = {step / 2};
        visit(root, groups, group -> {
            List<Light> lights = new ArrayList<>();
            for (int i = group.first; i < group.end; i++) {
                for (left[0] -= luminances[pixels[i]]; left[0] < 0; left[0] += step) {
                    lights.add(pixelLight(pixels[i], step));
                }
            }
            all.add(new Group(lights, group.light.deviation()));
        });
        return all;
    }

    /** Returns a light in a pixel's direction, with its color and a luminance. */
    private Light pixelLight(int pixel, double luminance) {
        int row = pixel / map.width();
        double scale = luminance / (map.luminance(row, pixel % map.width()) * Math.PI);
        Vector3f color = new Vector3f();
        for (int c = 0; c < 3; c++) {
            color.setComponent(c, (float) (scale * map.value(row, pixel % map.width(), c)));
        }
        Vector3f towards = new Vector3f(directions[3 * pixel], directions[3 * pixel + 1], directions[3 * pixel + 2]);
        return new Light(towards, color, 0, new Vector3f());
    }

    private static void visit(Region region, int count, Consumer<Region> each) {
        if (region.step < count) {
            visit(region.left, count, each);
            visit(region.right, count, each);
        } else {
            each.accept(region);
        }
    }
}
