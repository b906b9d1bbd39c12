package sunbeam.app.scene.environment;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import jrtr.scene.Light;
import org.joml.Vector3d;
import org.joml.Vector3f;

/** Maps that are computed. A white surface that faces their brightest side has the radiance 1, except under {@code sky}. */
final class BuiltInEnvironments {
    // Rows. A pixel of the fine ones is somewhat larger than the sun.
    private static final int FINE = 256;
    private static final int SMOOTH = 128;
    private static final int FACES = 512;
    // Points along a pixel's side, so that edges keep their light.
    private static final int POINTS = 4;
    private static final double SUN_RADIUS = Math.toRadians(0.53 / 2);
    private static final Vector3d SUN = RadianceMap.direction(Math.toRadians(-30), Math.toRadians(20));
    // Irradiance of the low sun over that of its sky.
    private static final double SUN_SHARE = 3;

    /** Linear Rec. 709 in a direction, by azimuth and elevation in degrees. */
    private interface Sky {
        double[] at(double azimuth, double elevation);
    }

    private static final Map<String, Sky> SKIES = new LinkedHashMap<>();

    static {
        SKIES.put("window", BuiltInEnvironments::window);
        SKIES.put("overcast", BuiltInEnvironments::overcast);
        SKIES.put("sun", BuiltInEnvironments::clear);
        SKIES.put("sky", BuiltInEnvironments::sky);
    }

    static final List<String> NAMES = List.copyOf(SKIES.keySet());

    /** A class of its own, since the threads that compute the map wait for as long as the outer class is being initialized. */
    static final class Shared {
        static final RadianceMap SKY = of("sky");

        private Shared() {}
    }

    private BuiltInEnvironments() {}

    static RadianceMap of(String name) {
        int height = name.equals("sky") || name.equals("overcast") ? SMOOTH : FINE;
        int width = 2 * height;
        float[] rgb = new float[3 * height * width];
        RadianceMap map = new RadianceMap(height, rgb);
        Sky sky = SKIES.get(name);
        IntStream.range(0, height * width).parallel().forEach(pixel -> {
            for (int point = 0; point < POINTS * POINTS; point++) {
                int line = pixel / width;
                int right = point / POINTS;
                double row = line + (point % POINTS + 0.5) / POINTS - 0.5;
                double column = pixel % width + (right + 0.5) / POINTS - 0.5;
                double azimuth = Math.toDegrees(map.azimuth(column));
                double[] color = sky.at(azimuth, Math.toDegrees(map.elevation(row)));
                for (int c = 0; c < 3; c++) {
                    rgb[3 * pixel + c] += (float) (color[c] / (POINTS * POINTS));
                }
            }
        });
        if (name.equals("sun")) {
            addSun(map, rgb);
        }
        if (!name.equals("sky")) {
            float white = (float) LightTree.white(faces(map));
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] /= white;
            }
        }
        return map;
    }

    private static List<Light> faces(RadianceMap map) {
        return LightTree.of(map, FACES).groups(FACES, 1).get(0).lights();
    }

    private static double[] gray(double value) {
        return new double[] {value, value, value};
    }

    /** @param azimuth in degrees, of any turn */
    private static boolean isBetween(double azimuth, double least, double most) {
        return Math.abs(Math.IEEEremainder(azimuth - (least + most) / 2, 360)) < (most - least) / 2;
    }

    /** A room: a window of four panes, a dimmer one on the other side, and dim walls. */
    private static double[] window(double azimuth, double elevation) {
        boolean isFrame = Math.abs(Math.IEEEremainder(azimuth - 327.5, 360)) < 0.8 || Math.abs(elevation - 28.5) < 0.8;
        if (isBetween(azimuth, 310, 345) && elevation > 12 && elevation < 45 && !isFrame) {
            return new double[] {11.5, 12, 13};
        }
        if (isBetween(azimuth, 120, 150) && elevation > 20 && elevation < 60) {
            return gray(3);
        }
        return elevation > 0 ? new double[] {0.17, 0.15, 0.125} : gray(0.06);
    }

    /** The CIE's overcast sky (Moon and Spencer 1942), three times as bright at its zenith as at the horizon. */
    private static double[] overcast(double azimuth, double elevation) {
        return gray(elevation > 0 ? (1 + 2 * Math.sin(Math.toRadians(elevation))) / 3 : 0.1);
    }

    private static double[] clear(double azimuth, double elevation) {
        if (elevation <= 0) {
            return new double[] {0.12, 0.1, 0.08};
        }
        Vector3d direction = RadianceMap.direction(Math.toRadians(azimuth), Math.toRadians(elevation));
        double nearHorizon = Math.exp(-elevation / 20);
        double nearSun = Math.exp(-Math.toDegrees(Math.acos(Math.min(1, direction.dot(SUN)))) / 15);
        return new double[] {
            0.25 + 0.45 * nearHorizon + 1.2 * nearSun,
            0.42 + 0.35 * nearHorizon + 1.1 * nearSun,
            0.85 + 0.15 * nearHorizon + 0.9 * nearSun
        };
    }

    /** Adds the sun's disc to the pixels that it covers; its energy is exact however few they are. */
    private static void addSun(RadianceMap map, float[] rgb) {
        double sky = LightTree.white(faces(map));
        double covered = 0;
        float[] shares = new float[rgb.length / 3];
        int fine = 16;
        for (int pixel = 0; pixel < shares.length; pixel++) {
            int row = pixel / map.width();
            int column = pixel % map.width();
            Vector3d middle = RadianceMap.direction(map.azimuth(column), map.elevation(row));
            if (middle.dot(SUN) < Math.cos(4 * SUN_RADIUS)) {
                continue;
            }
            for (int i = 0; i < fine * fine; i++) {
                int down = i / fine;
                Vector3d point = RadianceMap.direction(
                        map.azimuth(column + (i % fine + 0.5) / fine - 0.5),
                        map.elevation(row + (down + 0.5) / fine - 0.5));
                shares[pixel] += point.dot(SUN) > Math.cos(SUN_RADIUS) ? 1f / (fine * fine) : 0;
            }
            covered += shares[pixel] * map.solidAngle(row);
        }
        double[] color = {1.12, 0.99, 0.75};
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] += (float) (SUN_SHARE * sky * Math.PI / covered * color[i % 3] * shares[i / 3]);
        }
    }

    /** A sky, brightest at its zenith, where it is white, with a soft bright window; scenes' key {@code sky}. */
    private static double[] sky(double azimuth, double elevation) {
        Vector3d direction = RadianceMap.direction(Math.toRadians(azimuth), Math.toRadians(elevation));
        double height = Math.max(0, direction.z);
        double towardsZenith = height * height * (3 - 2 * height);
        double beyond = Math.max(direction.z, 0.1);
        double window = 5
                * (1 - smooth(Math.abs(direction.x / beyond + 0.55) / 0.34))
                * (1 - smooth(Math.abs(direction.y / beyond - 0.4) / 0.26));
        double above = Math.max(0, Math.min(1, 20 * direction.z + 0.5));
        double[] zenith = {0.93, 1, 1.17};
        double[] horizon = {0.15, 0.155, 0.16};
        double[] below = {0.05, 0.05, 0.045};
        double[] xyz = new double[3];
        for (int c = 0; c < 3; c++) {
            double light = horizon[c] + towardsZenith * (zenith[c] - horizon[c]) + window * zenith[c];
            xyz[c] = below[c] + above * (light - below[c]);
        }
        Vector3f rgb = linearRgb(xyz);
        return new double[] {rgb.x, rgb.y, rgb.z};
    }

    private static double smooth(double at) {
        double t = Math.max(0, Math.min(1, (at - 0.2) / 1.4));
        return t * t * (3 - 2 * t);
    }

    private static Vector3f linearRgb(double[] xyz) {
        return new Vector3f(
                (float) (3.2404542 * xyz[0] - 1.5371385 * xyz[1] - 0.4985314 * xyz[2]),
                (float) (-0.9692660 * xyz[0] + 1.8760108 * xyz[1] + 0.0415560 * xyz[2]),
                (float) (0.0556434 * xyz[0] - 0.2040259 * xyz[1] + 1.0572252 * xyz[2]));
    }
}
