package sunbeam.app.cli.brdfmap;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import sunbeam.app.cli.brdfmap.MaterialMap.Result;
import sunbeam.app.files.plot.MapAnnotation;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

record MapSheet(List<Result> maps, DisplayTransform display) {
    private static final int MOST_COLUMNS = 3;
    private static final int GAP = 8;

    BufferedImage plain() {
        return sheet(maps.stream().map(this::disc).toList());
    }

    private BufferedImage disc(Result map) {
        return map.picture().shown(display);
    }

    /** Draws the maps with rings, marks and captions; the choices are those before a scan's size limits the coherence length. */
    BufferedImage annotated(Optional<String> index, String exposed, Choices asked) {
        Choices light = asked.only(LightSettings.ALL)
                .over(asked.only(List.of(SceneSettings.ROTATE_PATCH, SceneSettings.ANGULAR_DIAMETER)));
        String remarks = (light.chosen().isEmpty() ? "" : light.describe() + "; ")
                + index.map(words -> "refractive index " + words + "; ").orElse("");
        return sheet(maps.stream()
                .map(map -> new MapAnnotation(disc(map), map.light(), caption(map, remarks, asked, exposed)).draw())
                .toList());
    }

    /** Returns a paragraph for the patch, one for light and window with remarks on what differs from the defaults, and the last one. */
    private static List<String> caption(Result map, String remarks, Choices asked, String last) {
        Patch patch = map.patch();
        Direction light = map.light();
        ReferenceMethod exact = map.method().referenceMethod(patch.heights());
        String average = exact.area().average() == Average.COHERENT ? ", one coherence area" : ", ensemble average";
        Optional<String> side = ScanLimit.of(asked, patch).limiting();
        String size =
                length(patch.heights().width()) + " x " + length(patch.heights().height());
        String aim = Text.format(
                "light %s\u00b0 from the normal, azimuth %s\u00b0; ",
                degrees(Math.atan2(Math.hypot(light.x(), light.y()), light.z())),
                degrees(Math.atan2(light.y(), light.x())));
        String window = "coherence length " + length(map.coherenceLength())
                + side.map(limit -> " (the scan's " + limit + ")").orElse("")
                + (exact.replicas().isPresent() ? "" : average);
        return List.of(
                patch.name() + ": " + size + ", relief " + length(patch.scan().relief()),
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
        return maps.stream()
                .filter(map -> DoubtfulPicture.isBlack(disc(map)))
                .map(Result::patch)
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

    /** Lays pictures side by side, at most three in a row, tops aligned, transparent between them; a single one stays. */
    private static BufferedImage sheet(List<BufferedImage> pictures) {
        if (pictures.size() == 1) {
            return pictures.get(0);
        }
        int columns = Math.min(MOST_COLUMNS, pictures.size());
        int rows = (pictures.size() + columns - 1) / columns;
        int width = pictures.stream().mapToInt(BufferedImage::getWidth).max().orElseThrow();
        int height = pictures.stream().mapToInt(BufferedImage::getHeight).max().orElseThrow();
        BufferedImage sheet = new BufferedImage(
                columns * (width + GAP) - GAP, rows * (height + GAP) - GAP, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = sheet.createGraphics();
        for (int i = 0; i < pictures.size(); i++) {
            graphics.drawImage(pictures.get(i), i % columns * (width + GAP), i / columns * (height + GAP), null);
        }
        graphics.dispose();
        return sheet;
    }
}
