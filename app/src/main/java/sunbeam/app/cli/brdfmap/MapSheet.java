package sunbeam.app.cli.brdfmap;

import static sunbeam.app.scene.SceneSettings.ANGULAR_DIAMETER;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import sunbeam.app.files.plot.MapAnnotation;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.setting.Choices;

record MapSheet(List<MaterialMap.Result> maps, DisplayTransform display) {
    private static final int MOST_COLUMNS = 3;

    private static final int GAP = 8;

    BufferedImage plain() {
        return sheet(maps.stream().map(this::disc).toList());
    }

    private BufferedImage disc(MaterialMap.Result map) {
        return map.picture().shown(display);
    }

    /**
     * Draws the maps with rings, marks and captions.
     *
     * @param index text about the refractive index for the caption; empty for the default
     * @param exposed text about the exposure for the caption
     * @param asked choices of the user, before a scan's size limits the coherence length
     */
    BufferedImage annotated(Optional<String> index, String exposed, Choices asked) {
        Choices light = asked.only(LightSettings.ALL).over(asked.only(List.of(ROTATE_PATCH, ANGULAR_DIAMETER)));
        Optional<String> spectrum = light.chosen().isEmpty() ? Optional.empty() : Optional.of(light.describe());
        return sheet(maps.stream()
                .map(map -> {
                    MapCaption.Remarks remarks = new MapCaption.Remarks(
                            spectrum, index, ScanLimit.of(asked, map.patch()).limiting());
                    List<String> caption =
                            MapCaption.of(map.patch(), map.light(), map.coherenceLength(), map.method(), remarks);
                    return new MapAnnotation(disc(map), map.light(), MapCaption.with(caption, exposed)).draw();
                })
                .toList());
    }

    Optional<Patch> black() {
        return maps.stream()
                .filter(map -> DoubtfulPicture.isBlack(disc(map)))
                .map(MaterialMap.Result::patch)
                .findFirst();
    }

    List<Patch> patches() {
        return maps.stream().map(MaterialMap.Result::patch).distinct().toList();
    }

    Map<String, String> text() {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "BRDF map of " + joined(patches(), Patch::name, ", "));
        text.put("Patch", joined(patches(), Patch::source, "; "));
        text.put("Plan", joined(maps, MaterialMap.Result::plan, "; "));
        if (!maps.get(0).trial().isEmpty()) {
            text.put("Table", joined(maps, MaterialMap.Result::trial, "; "));
        }
        text.put("Exposure", Double.toString(display.exposure()));
        return text;
    }

    private static <T> String joined(List<T> parts, Function<T, String> words, String between) {
        return parts.stream().map(words).collect(Collectors.joining(between));
    }

    /** Lays pictures side by side, at most three in a row, tops aligned, transparent between them; a single one is returned unchanged. */
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
