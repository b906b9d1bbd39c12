package sunbeam.app.scene.texture;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import sunbeam.precompute.color.Srgb;

/** Color of a snake's body. */
public interface BodyColors {

    /**
     * Returns linear sRGB, 0 to 1, at a place.
     *
     * @param along texture coordinate u, from the snout
     * @param around angle from the middle of the back over pi: 0 on the back, -1 and 1 in the middle of the belly
     */
    Vector3dc at(double along, double around);

    /** In linear light colors mix. */
    static Vector3dc ofSrgb(int rgb) {
        return new Vector3d(Srgb.linear(rgb >> 16 & 0xff), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff));
    }

    static double step(double from, double to, double value) {
        double t = Math.min(1, Math.max(0, (value - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }

    /** Sunbeam snake (Xenopeltis unicolor): nearly black brown, so that only diffraction colors it, with a pale belly and lips. */
    final class Xenopeltis implements BodyColors {
        private static final Vector3dc BACK = ofSrgb(0x1c1619);
        private static final Vector3dc FLANK = ofSrgb(0x2e2523);
        private static final Vector3dc BELLY = ofSrgb(0xcdbfa8);

        private final SnakeHead head = new SnakeHead(ofSrgb(0x3a2a1c));
        private final SkinNoise grain = new SkinNoise(5, 1600, 120);
        private final SkinNoise mottle = new SkinNoise(6, 200, 12);

        @Override
        public Vector3dc at(double along, double around) {
            double side = Math.abs(around);
            Vector3dc skin = BACK.lerp(FLANK, step(0.3, 0.7, side), new Vector3d());
            double mottled = mottle.at(along, around);
            Vector3dc uneven = skin.mul(1 + 0.12 * grain.at(along, around) + 0.12 * mottled, new Vector3d());
            // The upper lip is pale; behind the head the edge sinks to the belly's shields.
            double edge = 0.52 + 0.2 * step(0.6, 1, along / ScaleRelief.BEGIN);
            Vector3dc pale = uneven.lerp(BELLY, step(edge, edge + 0.04, side), new Vector3d());
            return along < ScaleRelief.BEGIN ? head.at(along / ScaleRelief.BEGIN, side, pale) : pale;
        }
    }

    /** Corn snake (Pantherophis guttatus, the thesis's Elaphe guttata): red saddles, smaller blotches on the flanks, a checkered belly. */
    final class Elaphe implements BodyColors {
        private static final Vector3dc GROUND = ofSrgb(0xc98243);
        private static final Vector3dc FLANK = ofSrgb(0xbf9a6c);
        private static final Vector3dc SADDLE = ofSrgb(0x9c3216);
        private static final Vector3dc EDGE = ofSrgb(0x1d1210);
        private static final Vector3dc CREAM = ofSrgb(0xe6d8bd);
        // On the body 27 to 40, smaller ones on the tail.
        private static final double SADDLES = 38;
        // On either side: back 0, middle of the belly 1.
        private static final double BELLY_BEGIN = 0.76;
        // Each check is two shields long.
        private static final int BELLY_SHIELDS = 150;
        // Superellipse distance without color: the outline at 1 wobbles by 0.11, its edge reaches 0.04 farther.
        private static final double FARTHEST = 1.16;
        private static final double OUTER_EDGE = -0.04;

        private final SnakeHead head = new SnakeHead(ofSrgb(0x8a4a1c));
        private final SkinNoise outline = new SkinNoise(1, 400, 24);
        private final double[] saddleSizes = sizes(0.16, 0);
        private final double[] blotchSizes = sizes(0.3, 0.9);
        private final SkinNoise grain = new SkinNoise(3, 1600, 120);
        private final SkinNoise mottle = new SkinNoise(4, 260, 16);

        @Override
        public Vector3dc at(double along, double around) {
            return along < ScaleRelief.BEGIN ? head(along / ScaleRelief.BEGIN, around) : body(along, around);
        }

        private Vector3dc head(double along, double around) {
            double side = Math.abs(around);
            Vector3dc ground = GROUND.lerp(FLANK, step(0.3, 0.6, side), new Vector3d());
            Vector3dc pale = ground.lerp(CREAM, step(0.55, 0.68, side), new Vector3d());
            double spear = 2.4 * (1 - superellipse((along - 1.1) / 0.82, side / (0.04 + 0.2 * along)));
            double band = 1.6 * (1 - superellipse((along - 0.44) / 0.24, (side - 0.22 - 0.42 * along) / 0.1));
            Vector3dc marked = mark(mark(pale, Math.min(spear, 4 * (0.97 - along))), band);
            double grained = 1 + 0.1 * grain.at(ScaleRelief.BEGIN * along, around);
            return head.at(along, side, marked.mul(grained, new Vector3d()));
        }

        /** Each scale has the markings of its middle. */
        private Vector3dc body(double u, double around) {
            double[] scale = ScaleRelief.middleOfScale(Scales.KEELED, u, around);
            double middle = Math.max(0, (scale[0] - ScaleRelief.BEGIN) / (1 - ScaleRelief.BEGIN));
            double middleSide = Math.abs(scale[1]);
            double along = (u - ScaleRelief.BEGIN) / (1 - ScaleRelief.BEGIN);
            double side = Math.abs(around);
            double mottled = 0.1 * mottle.at(along, around);
            Vector3dc ground = GROUND.lerp(FLANK, step(0.25, 0.7, side + mottled), new Vector3d());
            double wobble = 0.11 * outline.at(middle, scale[1]);
            double saddle = depth(middle * SADDLES, 0.36, middleSide, 0.42, saddleSizes);
            double blotch = depth(middle * SADDLES + 0.5, 0.24, middleSide - 0.56, 0.13, blotchSizes);
            Vector3dc marked = mark(mark(ground, saddle + wobble), blotch + wobble);
            Vector3dc skin = marked.mul(1 + 0.13 * grain.at(along, around) + mottled, new Vector3d());
            double share = step(BELLY_BEGIN - 0.02, BELLY_BEGIN + 0.04, side);
            return share == 0 ? skin : skin.lerp(belly(along, around), share, new Vector3d());
        }

        /** Red inside, black along the outline. */
        private static Vector3dc mark(Vector3dc ground, double depth) {
            if (depth <= OUTER_EDGE) {
                return ground;
            }
            Vector3dc edged = ground.lerp(EDGE, step(OUTER_EDGE, 0.06, depth), new Vector3d());
            return edged.lerp(SADDLE, step(0.24, 0.36, depth), new Vector3d());
        }

        /** Relative sizes along the body; they vary by at most the spread. */
        private static double[] sizes(double spread, double around) {
            SkinNoise sizes = new SkinNoise(2, 60, 2);
            double[] all = new double[(int) SADDLES + 2];
            for (int i = 0; i < all.length; i++) {
                all[i] = 1 + spread * sizes.at((i + 0.5) / SADDLES, around);
            }
            return all;
        }

        /** Depth inside the nearest marking: 1 in its middle, 0 on its outline. */
        private static double depth(double place, double halfLength, double beside, double halfWidth, double[] sizes) {
            int number = (int) place;
            double size = sizes[number];
            return 1 - superellipse((place - (number + 0.5)) / (halfLength * size), beside / (halfWidth * size));
        }

        /** Distance from the middle of a rounded rectangle (x and y from -1 to 1); approximate beyond {@link #FARTHEST}. */
        private static double superellipse(double x, double y) {
            double least = Math.max(Math.abs(x), Math.abs(y));
            return least > FARTHEST
                    ? least
                    : Math.pow(Math.pow(Math.abs(x), 2.6) + Math.pow(Math.abs(y), 2.6), 1 / 2.6);
        }

        private Vector3dc belly(double along, double around) {
            int shield = (int) Math.floor(along * BELLY_SHIELDS);
            int column = (int) Math.floor((1 - Math.abs(around)) / 0.08) + (around < 0 ? 1 : 0);
            boolean dark = Math.floorMod(shield / 2 + column, 2) == 0;
            return dark
                    ? EDGE.lerp(CREAM, 0.05, new Vector3d())
                    : CREAM.mul(1 + 0.05 * grain.at(along, around), new Vector3d());
        }
    }

    /** Smooth noise between -1 and 1 over the body, seamless at the belly, of independent values along and around it. */
    record SkinNoise(int seed, int cellsAlong, int cellsAround) {
        /** Along the body from 0 to 1, around it from -1 to 1. */
        double at(double along, double around) {
            double x = along * cellsAlong;
            double y = 0.5 * (around + 1) * cellsAround;
            // A cast equals the floor of numbers from 0 on, and is faster.
            int left = (int) x;
            int below = (int) y;
            double fx = smooth(x - left);
            double fy = smooth(y - below);
            double low = value(left, below) * (1 - fx) + value(left + 1, below) * fx;
            double high = value(left, below + 1) * (1 - fx) + value(left + 1, below + 1) * fx;
            return low * (1 - fy) + high * fy;
        }

        private static double smooth(double t) {
            return t * t * (3 - 2 * t);
        }

        private double value(int column, int row) {
            return hash(seed + 0x9e3779b9 * column + 0x85ebca6b * Math.floorMod(row, cellsAround));
        }

        /** Pseudorandom from -1 to 1: the finalizer of MurmurHash3 (A. Appleby) spreads neighbors over all 32 bits. */
        static double hash(int number) {
            int h = (number ^ number >>> 16) * 0x85ebca6b;
            h = (h ^ h >>> 13) * 0xc2b2ae35;
            return (h ^ h >>> 16) / 2147483648.0;
        }
    }

    /** Eyes, mouth and shields of a snake's head: their colors over the skin's, and relief. */
    record SnakeHead(Vector3dc iris) {
        /** Along the head: snout 0, neck 1. */
        public static final double EYE_ALONG = 0.27;

        /** Around the head: top 0, bottom 1. */
        public static final double EYE_AROUND = 0.32;

        // Half sizes, as shares of the head's length and half girth.
        private static final double EYE_LENGTH = 0.058;
        private static final double EYE_HEIGHT = 0.086;
        private static final double NOSTRIL_ALONG = 0.075;
        private static final double NOSTRIL_AROUND = 0.33;
        private static final double NOSTRIL_SIZE = 0.016;
        private static final Vector3dc PUPIL = ofSrgb(0x060505);
        // Across the top, snout 0 to neck 1; the frontal shield lies between the third and the fourth.
        private static final double[] SEAMS = {0.09, 0.17, 0.29, 0.5, 0.76};
        private static final double SEAM_WIDTH = 0.009;
        private static final double DARKEST_SEAM = 0.72;
        // In lengths of the head: a tenth of a millimeter each.
        private static final double GROOVE_DEPTH = 0.0022;
        private static final double ROUNDING = 0.002;
        // Edge of the top's shields and half width of the frontal one; top 0, bottom 1.
        private static final double TOP_EDGE = 0.27;
        private static final double FRONTAL_HALF_WIDTH = 0.1;
        // Line of the mouth and width of each lip; top 0, bottom 1.
        private static final double MOUTH = 0.62;
        private static final double LIP_WIDTH = 0.1;
        private static final double MOUTH_WIDTH = 0.013;
        // Groove around the eye, in radii of the eye.
        private static final double SOCKET = 1.1;
        private static final double SOCKET_WIDTH = 0.2;
        // Height of the eye's dome in lengths of the head, over that of the mesh.
        private static final double CORNEA = 0.011;
        // In lengths of the head.
        static final double HALF_GIRTH = 0.5;

        /** Returns the color: {@code along} from snout 0 to neck 1, {@code side} from top 0 to bottom 1. */
        Vector3dc at(double along, double side, Vector3dc skin) {
            Vector3d color = skin.mul(1 - (1 - DARKEST_SEAM) * seam(along, side, 1), new Vector3d());
            double mouth = line(side - mouth(along), MOUTH_WIDTH) * (1 - step(0.6, 0.7, along));
            color.lerp(PUPIL, 0.85 * mouth);
            color.lerp(PUPIL, 1 - step(0.6, 1.2, nostril(along, side)));
            double eye = eye(along, side);
            color.lerp(PUPIL, 1 - step(1, 1.25, eye));
            color.lerp(iris, step(0.5, 0.58, eye) * (1 - step(0.82, 0.95, eye)));
            return color;
        }

        /** Distance from the middle of the eye, 1 on its edge. */
        private static double eye(double along, double side) {
            return Math.hypot((along - EYE_ALONG) / EYE_LENGTH, (side - EYE_AROUND) / EYE_HEIGHT);
        }

        /** Distance from the middle of the nostril, 1 on its edge. */
        private static double nostril(double along, double side) {
            return Math.hypot(along - NOSTRIL_ALONG, HALF_GIRTH * (side - NOSTRIL_AROUND)) / NOSTRIL_SIZE;
        }

        /** True on the eye, whose spectacle is smooth; at u, and at an angle from the middle of the back over pi. */
        static boolean isEye(double u, double around) {
            return u < ScaleRelief.BEGIN && eye(u / ScaleRelief.BEGIN, Math.abs(around)) < 1;
        }

        /**
         * Returns the height in lengths of the head; the shields' edges sink to the seams.
         *
         * @param along from snout 0 to neck 1
         * @param around top 0, bottom 1 and -1
         */
        static double height(double along, double around) {
            double side = Math.abs(around);
            double eye = eye(along, side);
            double socket = Math.exp(-Math.pow((eye - SOCKET) / SOCKET_WIDTH, 2));
            double lips = line(side - mouth(along), 3 * MOUTH_WIDTH) * (1 - step(0.6, 0.7, along));
            return -GROOVE_DEPTH
                            * (seam(along, side, 2.2)
                                    + 2 * socket
                                    + lips
                                    + 3 * (1 - step(0.4, 1.6, nostril(along, side))))
                    - ROUNDING * seam(along, side, 6)
                    + CORNEA * Math.max(0, 1 - eye * eye);
        }

        /** Place around the head of the line between the lips. */
        private static double mouth(double along) {
            return MOUTH - 0.07 * (along - 0.4) * (along - 0.4);
        }

        private static double seam(double along, double side, double widening) {
            double width = widening * SEAM_WIDTH;
            double seam = 0;
            double top = 1 - step(TOP_EDGE, TOP_EDGE + 0.03, side);
            for (double at : SEAMS) {
                seam = Math.max(seam, line(along - at - 0.12 * side * (0.5 - at), width) * top);
            }
            boolean isFrontal = along > SEAMS[2] && along < SEAMS[3];
            double end = 1 - step(SEAMS[4], SEAMS[4] + 0.01, along);
            seam = Math.max(seam, end * line(side - (isFrontal ? FRONTAL_HALF_WIDTH : 0), 2 * width));
            seam = Math.max(seam, end * line(side - TOP_EDGE, 2 * width));
            double lip = step(MOUTH - LIP_WIDTH, MOUTH - LIP_WIDTH + 0.02, side)
                    * (1 - step(MOUTH + LIP_WIDTH, MOUTH + LIP_WIDTH + 0.02, side));
            double shields = along / 0.085;
            return Math.max(seam, 0.7 * lip * line((shields - Math.rint(shields)) * 0.085, width));
        }

        private static double line(double distance, double width) {
            return 1 - step(0.3 * width, width, Math.abs(distance));
        }
    }
}
