package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import jrtr.Binding;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.Texture;
import jrtr.scene.Material;
import sunbeam.app.gpu.DiffractionMethod;
import sunbeam.app.gpu.MethodUse;
import sunbeam.app.gpu.Shaders;

/** A diffraction method on a mesh: its tables and the program shaders/mesh.frag with it compiled in. */
final class SkinSurface implements AutoCloseable {
    private final DiffractionMethod method;
    private final ShaderProgram program;

    private SkinSurface(DiffractionMethod method, ShaderProgram program) {
        this.method = method;
        this.program = program;
    }

    /** Resamples and uploads the tables, and compiles. */
    static SkinSurface create(RenderContext context, SceneData data) {
        DiffractionMethod method = data.method().create(context, MethodUse.COLOUR, data.table());
        try {
            ShaderProgram program = context.createMeshProgram(Shaders.library().load("mesh.frag", method.defines()));
            method.setUniforms(program);
            return new SkinSurface(method, program);
        } catch (RuntimeException failure) {
            method.close();
            throw failure;
        }
    }

    /** The material of a scene. */
    Material material(Scene scene, Texture body) {
        List<Binding> textures = new ArrayList<>(method.bindings());
        textures.add(new Binding("bodyTexture", body));
        Material material = new Material(program, textures);
        material.uniforms()
                .set("tangentRotation", (float) scene.rotatePatch())
                .set("diffractionWeight", (float) scene.blend().diffraction())
                .set("textureWeight", (float) scene.blend().texture())
                .set("diffuseWeight", (float) scene.blend().diffuse())
                .set("ambientWeight", (float) scene.blend().ambient());
        return material;
    }

    @Override
    public void close() {
        program.close();
        method.close();
    }
}
