package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import jrtr.Binding;
import jrtr.FloatTarget;
import jrtr.FloatTexture;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.Tile;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.precompute.color.CieTable;

/** A diffraction method on a mesh: its tables and the program shaders/skin.frag with it compiled in. */
final class SkinSurface implements AutoCloseable {
    private final UploadedTables method;
    private final ShaderProgram program;
    private final Optional<SkinLooks> looks;

    private SkinSurface(UploadedTables method, ShaderProgram program, Optional<SkinLooks> looks) {
        this.method = method;
        this.program = program;
        this.looks = looks;
    }

    /** Uploads the tables and compiles. */
    static SkinSurface create(RenderContext context, SceneData data) {
        UploadedTables method = UploadedTables.upload(context, data.tables());
        try {
            ShaderProgram program = method.program("skin.frag");
            Optional<SkinLooks> looks = data.levels().map(sources -> new SkinLooks(context, sources));
            looks.ifPresent(found -> found.prepare(program));
            return new SkinSurface(method, program, looks);
        } catch (RuntimeException | OutOfMemoryError failure) {
            method.close();
            throw failure;
        }
    }

    /** The tables, which others in this context may draw with for as long as the surface is there. */
    UploadedTables method() {
        return method;
    }

    /** Where its colours are made as pixels look into them: how they do. */
    Optional<SkinLooks> looks() {
        return looks;
    }

    /**
     * Lights texels of a block.
     *
     * @param sources which, by {@link GeometryBuffer#texel}; -1 for none
     * @param target as large as the sources; where there is none, it stays as it is
     * @param tile part of the target
     */
    void shade(
            RenderContext context,
            Scene scene,
            GeometryBuffer buffer,
            FloatTexture sources,
            FloatTarget target,
            Tile tile) {
        SceneUniforms.set(program, scene);
        // The same at all wavelengths.
        program.set("normalReflectance", (float) scene.index().reflectance(CieTable.MINIMUM_WAVELENGTH));
        List<Binding> textures = new ArrayList<>(method.bindings());
        textures.addAll(buffer.bindings());
        looks.ifPresent(found -> textures.addAll(found.bindings()));
        textures.add(new Binding("sources", sources));
        context.drawFullScreen(program, textures, target, tile);
    }

    @Override
    public void close() {
        looks.ifPresent(SkinLooks::close);
        program.close();
        method.close();
    }
}
