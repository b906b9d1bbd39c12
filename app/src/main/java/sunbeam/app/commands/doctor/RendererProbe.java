package sunbeam.app.commands.doctor;

import java.util.List;
import jrtr.ContextInfo;
import jrtr.ContextLimits;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;

/** Opens the context that rendering uses, and closes it. */
public final class RendererProbe implements GraphicsProbe {
    @Override
    public List<Check> examine() {
        try (RenderContext context = RenderContexts.offscreen()) {
            return describe(context.info());
        }
    }

    private static List<Check> describe(ContextInfo info) {
        ContextLimits limits = info.limits();
        return List.of(
                Check.ok("GL vendor", info.vendor()),
                Check.ok("GL renderer", info.renderer() + (info.software() ? ", in software" : "")),
                Check.ok("GL version", info.version() + ", GLSL " + info.shadingLanguageVersion()),
                Check.ok("Texture size", limits.textureSize() + " x " + limits.textureSize() + " texels"),
                Check.ok("Array layers", Integer.toString(limits.arrayLayers())),
                Check.ok("Picture size", limits.targetWidth() + " x " + limits.targetHeight() + " pixels"));
    }
}
