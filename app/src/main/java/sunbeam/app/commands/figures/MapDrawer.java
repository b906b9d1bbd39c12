package sunbeam.app.commands.figures;

import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.commands.figures.Panel.MapPanel;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.plot.MapAnnotation;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.app.gpu.map.MapCaption;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** Draws the maps, and each map that others are compared with once. */
final class MapDrawer implements AutoCloseable {
    private final FigurePatches patches;
    private final PanelStore store;
    private final int size;
    private final RenderContext context;
    private final Map<MapKey, DrawnMap> drawn = new HashMap<>();

    /** What two panels with the same map have in common. */
    private record MapKey(Role role, double thetaDegrees, Method method) {}

    /** A map, the exposure that fits it, and what was computed. */
    private record DrawnMap(LinearPicture map, double exposure, double coherenceLength, String summary) {}

    MapDrawer(FigurePatches patches, PanelStore store, int size) {
        this.patches = patches;
        this.store = store;
        this.size = size;
        this.context = RenderContexts.offscreen();
    }

    /** Draws and writes a map; returns the texts of its picture. */
    Map<String, String> draw(MapPanel panel) {
        DrawnMap map = map(panel);
        Map<String, String> text = new LinkedHashMap<>();
        double exposure = map.exposure();
        String caption = panel.label() + "; " + map.summary();
        if (panel.base().isPresent()) {
            DrawnMap base = map(panel.base().get());
            exposure = base.exposure();
            caption += "; against '" + panel.base().get().label() + "' it "
                    + MapDifference.of(map.map(), base.map(), exposure).text();
        }
        caption += String.format(Locale.ROOT, "; exposure %.3g", exposure);
        text.put(PanelStore.CAPTION, caption);
        text.put("Light", String.format(Locale.ROOT, "theta %s degrees", panel.thetaDegrees()));
        text.put("Method", panel.method().type().label());
        text.put("Plan", map.summary());
        text.put("Exposure", Double.toString(exposure));
        text.put("Renderer", context.info().renderer());
        BufferedImage image = map.map().shown(new DisplayTransform(exposure, Tone.COMPRESS));
        Direction light = Direction.ofDegrees(panel.thetaDegrees(), 0);
        List<String> below =
                MapCaption.of(patches.setup(panel.role()).patch(), light, map.coherenceLength(), panel.method());
        String exposed = MapAnnotation.exposureText(exposure);
        return store.write(panel, new MapAnnotation(image, light, MapCaption.with(below, exposed)).draw(), text);
    }

    private DrawnMap map(MapPanel panel) {
        MapKey key = new MapKey(panel.role(), panel.thetaDegrees(), panel.method());
        DrawnMap known = drawn.get(key);
        if (known != null) {
            return known;
        }
        DrawnMap map = render(panel);
        if (panel.base().isEmpty()) {
            drawn.put(key, map);
        }
        return map;
    }

    private DrawnMap render(MapPanel panel) {
        DiffractionSetup setup = patches.setup(panel.role());
        Direction light = Direction.ofDegrees(panel.thetaDegrees(), 0);
        MethodPlan plan = panel.method().plan(setup.surface(), VisibleRange.of(light));
        // A hundred tables that no other command asks for: the cache is spared them.
        ShaderTables tables = setup.freshTables(plan, MethodUse.COLOUR, GpuColours::of);
        try (UploadedTables method = UploadedTables.upload(context, tables);
                BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size);
                Progress progress = Progress.start(panel.name(), (long) size * size)) {
            LinearPicture map = renderer.render(light, progress::step);
            double exposure = AutoExposure.of(map);
            return new DrawnMap(map, exposure, 4 * method.windowSigma(), plan.summary());
        }
    }

    @Override
    public void close() {
        context.close();
    }
}
