package sunbeam.app.cli;

import static sunbeam.app.scene.SceneSettings.ANGULAR_DIAMETER;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.precompute.colortable.ColorTable.MIDDLE_WAVELENGTH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import org.joml.Vector3d;
import org.joml.Vector3f;
import sunbeam.app.cli.Certificate.Limits;
import sunbeam.app.cli.MaterialMap.Result;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.MapAnnotation;
import sunbeam.app.gpu.BrdfMapRenderer;
import sunbeam.app.gpu.BrdfMapRenderer.DiscDirections;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.Energy;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;
import sunbeam.precompute.work.Progress;

/**
 * BRDF map of one patch of any material: the sum of one map for each part of its reflection and of a lamp. Shaders compute the standard
 * material; for another, each map is multiplied by a factor that depends only on the pair of directions. A lamp's directions blur (u, v);
 * as in scenes, the ensemble under a shorter window has the same blur at 550 nm.
 */
final class MaterialMap {
    // Distance between a lamp's directions, in deviations of an order under the shorter window, as in footprint.glsl.
    private static final double SPACING = 1.6;
    private static final int MOST_DIRECTIONS = 8;
    // Points of a certificate's lamp, each as slow as a point of light.
    private static final int FEWEST_OF_DISC = 24;
    private static final int MOST_OF_DISC = 256;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private final DiffractionSetup setup;
    private final Choices choices;
    private final Method method;
    private final RefractiveIndex index;
    private final Direction light;
    private final List<Part> parts;

    private record Point(Direction towards, double share, Choices choices) {}

    /** Map to add: one part of the reflection under one point of light, divided where energy is conserved. */
    private record Part(Point point, ReflectionPart reflection, CieTable cie, MethodPlan plan) {}

    /** A drawn map with its patch, light and settings, and the validation of each part's color table, empty without tables. */
    record Result(
            Patch patch,
            Direction light,
            Method method,
            String plan,
            String trial,
            double coherenceLength,
            LinearPicture picture) {}

    /** @throws SettingException if the choices have a lamp and no ensemble average */
    MaterialMap(DiffractionSetup setup, Choices choices, RefractiveIndex index, Direction light) {
        this.setup = setup;
        this.choices = choices;
        this.method = Methods.of(choices);
        this.index = index;
        this.light = light;
        Optional<EnergyDivisor> divisor = choices.get(SceneSettings.ENERGY, Energy.SCALAR)
                .divisor(setup.patch().heights(), index, choices);
        List<ReflectionPart> reflections =
                ReflectionPart.of(index, setup.cie(), method.fresnel().exponent());
        this.parts = points().stream()
                .flatMap(point -> reflections.stream().map(part -> part(point, part, divisor)))
                .toList();
    }

    private Part part(Point point, ReflectionPart reflection, Optional<EnergyDivisor> divisor) {
        Direction inPatch = point.towards.turned(-choices.get(ROTATE_PATCH));
        CieTable cie =
                divisor.map(found -> found.under(inPatch, reflection.cie())).orElse(reflection.cie());
        MethodPlan plan = Methods.of(point.choices).plan(setup.surface().withLight(cie), VisibleRange.of(inPatch));
        return new Part(point, reflection, cie, plan);
    }

    private List<Point> points() {
        double diameter = choices.get(ANGULAR_DIAMETER, 0.0);
        if (diameter == 0) {
            return List.of(new Point(light, 1, choices));
        }
        if (Preset.isThesis(choices) || !method.type().has(AVERAGE) || choices.get(AVERAGE) != Average.ENSEMBLE) {
            throw SettingException.of(
                    ANGULAR_DIAMETER, diameter, "needs the ensemble average of methods full and table; leave it out");
        }
        Vector3f towards = new Vector3f((float) light.x(), (float) light.y(), (float) light.z());
        return new SceneLight(towards, 1, diameter)
                .narrow().stream().flatMap(this::points).toList();
    }

    /** Spreads a lamp's light along its major axis in (u, v), across the plane of incidence; the window blurs both axes alike. */
    private Stream<Point> points(SceneLight lamp) {
        double sine = Math.hypot(lamp.towards().x(), lamp.towards().y());
        double minor = lamp.deviation() * Math.max(lamp.towards().z(), Math.sqrt(12) / (SPACING * MOST_DIRECTIONS));
        CoherenceWindow window = GaussianArea.windowOf(choices);
        double frequency = window.sigmaFrequency();
        // Power is the square of an amplitude.
        double wider = Math.hypot(frequency, Math.sqrt(2) * minor / MIDDLE_WAVELENGTH);
        Choices shorter = choices.with(COHERENCE_LENGTH, window.coherenceLength() * frequency / wider);
        double length = Math.sqrt(12 * Math.max(0, Math.pow(lamp.deviation(), 2) - minor * minor));
        int count = Math.max(1, (int) Math.ceil(length / (SPACING * MIDDLE_WAVELENGTH * wider / Math.sqrt(2))));
        Vector3f across = sine > 0
                ? new Vector3f(-lamp.towards().y(), lamp.towards().x(), 0).div((float) sine)
                : new Vector3f(1, 0, 0);
        double share = lamp.intensity() * Math.pow(frequency / wider, 2) / count;
        return IntStream.range(0, count)
                .mapToObj(i -> across.mul((float) (length * ((i + 0.5) / count - 0.5)), new Vector3f())
                        .add(lamp.towards())
                        .normalize())
                .filter(point -> point.z() > 0)
                .map(point -> new Point(new Direction(point.x(), point.y(), point.z()), share, shorter));
    }

    MethodPlan plan() {
        return parts.get(0).plan;
    }

    /** Returns the plan in words; the tolerance holds for each point of a lamp only. */
    String summary() {
        double degrees = Math.rint(1e4 * Math.toDegrees(choices.get(ANGULAR_DIAMETER, 0.0))) * 1e-4;
        String words = "; a light %s degrees wide is blurred by a Gaussian, which looks like its disc but beside sharp"
                + " orders: median error %.2g %%, mean CIEDE2000 %.2g at most (--certify)";
        Limits most = limits();
        return plan().summary()
                + (isWide()
                        ? Text.format(words, Decimals.format(degrees), 100 * most.median(), most.meanDifference())
                        : "");
    }

    private Limits limits() {
        double tolerance = choices.get(TOLERANCE);
        return isWide() ? Limits.ofLamp(tolerance) : Limits.of(tolerance);
    }

    /** Compares random pixels with the reference, of a lamp with its mean over an even disc; the material must have no dispersion. */
    Certificate certify(LinearPicture picture, int count, double exposure) {
        Part part = parts.get(0);
        List<IntFunction<DirectionPair>> pairs = disc().stream()
                .map(towards -> new DiscDirections(picture.width(), towards))
                .<IntFunction<DirectionPair>>map(
                        directions -> pixel -> directions.at(pixel).turned(-choices.get(ROTATE_PATCH)))
                .toList();
        return new Certificate.Certifier(
                        setup.withLight(part.cie).exact(method), pairs, part.reflection::gain, setup.progress())
                .certify(picture, count, exposure, limits());
    }

    boolean isWide() {
        return choices.get(ANGULAR_DIAMETER, 0.0) > 0;
    }

    /** Returns points of equal light on the lamp's disc, closer than its orders are wide: a spiral by the golden angle (Vogel 1979). */
    private List<Direction> disc() {
        double diameter = choices.get(ANGULAR_DIAMETER, 0.0);
        double order = GaussianArea.windowOf(choices).sigmaFrequency() * MIDDLE_WAVELENGTH;
        double orders = Math.PI / 4 * Math.pow(diameter / order, 2);
        int count = isWide() ? (int) Math.max(FEWEST_OF_DISC, Math.min(MOST_OF_DISC, orders)) : 1;
        double sine = Math.hypot(light.x(), light.y());
        Vector3d towards = new Vector3d(light.x(), light.y(), light.z());
        Vector3d across = sine > 0 ? new Vector3d(-light.y() / sine, light.x() / sine, 0) : new Vector3d(1, 0, 0);
        Vector3d up = towards.cross(across, new Vector3d());
        return IntStream.range(0, count)
                .mapToObj(i -> {
                    double radius = 0.5 * diameter * Math.sqrt((i + 0.5) / count);
                    double angle = i * GOLDEN_ANGLE;
                    Vector3d point = new Vector3d(towards)
                            .fma(radius * Math.cos(angle), across)
                            .fma(radius * Math.sin(angle), up)
                            .normalize();
                    return new Direction(point.x, point.y, point.z);
                })
                .toList();
    }

    Result draw(RenderContext context, int size) {
        LinearPicture sum = null;
        double sigma = 0;
        List<String> trials = new ArrayList<>();
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            String label = "BRDF map" + (parts.size() > 1 ? " " + (i + 1) + " of " + parts.size() : "");
            ShaderTables made = setup.tables(part.plan, MethodUse.COLOR);
            trials.add(made.trial());
            try (UploadedTables tables = UploadedTables.upload(context, made);
                    BrdfMapRenderer renderer = new BrdfMapRenderer(context, tables, size, choices.get(ROTATE_PATCH));
                    Progress progress = setup.progress().start(label, (long) size * size)) {
                LinearPicture map = renderer.render(part.point.towards, progress::step);
                sum = sum == null ? scaled(map, part) : sum.plus(scaled(map, part));
                sigma = tables.tables().windowSigma();
            }
        }
        boolean isPoint = parts.get(0).point.choices.equals(choices);
        double length = isPoint ? 4 * sigma : GaussianArea.windowOf(choices).coherenceLength();
        String trial = trials.stream().filter(line -> !line.isEmpty()).collect(Collectors.joining("; "));
        return new Result(setup.patch(), light, method, summary(), trial, length, sum);
    }

    /** Multiplies a map by its share of the light, and by the material's reflectance over the standard one's. */
    private LinearPicture scaled(LinearPicture map, Part part) {
        boolean isStandard = index.isStandard();
        if (isStandard && part.point.share == 1) {
            return map;
        }
        DiscDirections directions = new DiscDirections(map.width(), part.point.towards);
        IntStream.range(0, map.width() * map.height())
                .parallel()
                .filter(map::covered)
                .forEach(pixel -> {
                    double factor =
                            part.point.share * (isStandard ? 1 : part.reflection.overStandard(directions.at(pixel)));
                    for (int c = 3 * pixel; c < 3 * pixel + 3; c++) {
                        map.xyz()[c] = (float) (factor * map.xyz()[c]);
                    }
                });
        return map;
    }

    /** @param discs the pictures of the maps, in their order */
    record MapSheet(List<Result> maps, DisplayTransform display, List<BufferedImage> discs) {
        private static final int MOST_COLUMNS = 2;
        private static final int GAP = 8;

        MapSheet(List<Result> maps, DisplayTransform display) {
            this(
                    maps,
                    display,
                    maps.stream().map(map -> map.picture().shown(display)).toList());
        }

        /** Draws the discs alone, side by side, at most two in a row, transparent between them. */
        BufferedImage plain() {
            if (discs.size() == 1) {
                return discs.get(0);
            }
            Drawing sheet = sheet(discs.stream().map(Drawing::of).toList());
            BufferedImage image = new BufferedImage(sheet.width(), sheet.height(), BufferedImage.TYPE_INT_ARGB);
            sheet.drawAt(image.createGraphics(), 0, 0);
            return image;
        }

        /** Draws the maps with rings, marks and captions; the choices are those before a scan's size limits the coherence length. */
        Drawing annotated(Optional<String> index, String exposed, Choices asked, double width) {
            Choices light = asked.only(MethodSettings.LIGHT)
                    .over(asked.only(List.of(SceneSettings.ROTATE_PATCH, SceneSettings.ANGULAR_DIAMETER)));
            String remarks = (light.chosen().isEmpty() ? "" : light.describe() + "; ")
                    + index.map(words -> "refractive index " + words + "; ").orElse("");
            return sheet(IntStream.range(0, maps.size())
                    .mapToObj(i -> new MapAnnotation(
                                    discs.get(i),
                                    maps.get(i).light(),
                                    caption(maps.get(i), remarks, asked, exposed),
                                    width / Math.min(MOST_COLUMNS, maps.size()))
                            .draw())
                    .toList());
        }

        /** Returns a paragraph for the patch, one for light and window with remarks on what differs from the defaults, and the last one. */
        private static List<String> caption(Result map, String remarks, Choices asked, String last) {
            Patch patch = map.patch();
            Direction light = map.light();
            ReferenceMethod exact = map.method().referenceMethod(patch.heights());
            String average = exact.area().average() == Average.COHERENT ? ", one coherence area" : ", ensemble average";
            Optional<String> side = ScanLimit.of(asked, patch).limiting();
            String size = length(patch.heights().width()) + " x "
                    + length(patch.heights().height());
            String aim = Text.format(
                    "light %s\u00b0 from the normal, azimuth %s\u00b0; ",
                    degrees(Math.atan2(Math.hypot(light.x(), light.y()), light.z())),
                    degrees(Math.atan2(light.y(), light.x())));
            String window = "coherence length " + length(map.coherenceLength())
                    + side.map(limit -> " (the scan's " + limit + ")").orElse("")
                    + (exact.replicas().isPresent() ? "" : average);
            return List.of(
                    patch.name() + ": " + size + ", relief "
                            + length(patch.scan().relief()),
                    aim + remarks + window + "; method " + map.method().type().label(),
                    last);
        }

        private static String length(double meters) {
            return Lengths.rounded(meters, 4);
        }

        private static String degrees(double radians) {
            return Decimals.format(Math.round(1e4 * Math.toDegrees(radians)) * 1e-4 + 0.0);
        }

        Optional<Patch> black() {
            return IntStream.range(0, maps.size())
                    .filter(i -> FileCommand.isBlack(discs.get(i)))
                    .mapToObj(i -> maps.get(i).patch())
                    .findFirst();
        }

        List<Patch> patches() {
            return maps.stream().map(Result::patch).distinct().toList();
        }

        Map<String, String> text() {
            Map<String, String> text = new LinkedHashMap<>();
            text.put("Title", "BRDF map of " + joined(patches(), Patch::name, ", "));
            text.put("Patch", joined(patches(), Patch::source, "; "));
            text.put("Plan", joined(maps, Result::plan, "; "));
            if (!maps.get(0).trial().isEmpty()) {
                text.put("Table", joined(maps, Result::trial, "; "));
            }
            text.put("Exposure", Double.toString(display.exposure()));
            return text;
        }

        private static <T> String joined(List<T> parts, Function<T, String> words, String between) {
            return parts.stream().map(words).collect(Collectors.joining(between));
        }

        private static Drawing sheet(List<Drawing> pictures) {
            if (pictures.size() == 1) {
                return pictures.get(0);
            }
            Drawing[] rows = IntStream.iterate(0, i -> i < pictures.size(), i -> i + MOST_COLUMNS)
                    .mapToObj(first -> pictures.subList(first, Math.min(first + MOST_COLUMNS, pictures.size())))
                    .map(row -> Drawing.row(GAP, row.toArray(Drawing[]::new)))
                    .toArray(Drawing[]::new);
            return Drawing.column(GAP, rows);
        }
    }
}
