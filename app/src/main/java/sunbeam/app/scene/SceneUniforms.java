package sunbeam.app.scene;

import java.util.List;
import jrtr.gl.ShaderProgram;
import jrtr.scene.LightUniforms;

/** What a scene tells the shaders that light geometry: jrtr/lights.glsl and include/blend.glsl. */
final class SceneUniforms {
    private SceneUniforms() {}

    static void set(ShaderProgram program, Scene scene) {
        LightUniforms.of(List.of(SceneGraphs.light(scene))).applyTo(program);
        Blend blend = scene.blend();
        program.set("diffractionWeight", (float) blend.diffraction());
        program.set("textureWeight", (float) blend.texture());
        program.set("diffuseWeight", (float) blend.diffuse());
        program.set("ambientWeight", (float) blend.ambient());
    }
}
