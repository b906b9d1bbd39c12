package jrtr.scene;

import jrtr.ShaderProgram;
import org.joml.Matrix3f;
import org.joml.Matrix4fc;

/** The uniforms of mesh.vert.glsl. */
final class PlaceUniforms {
    private PlaceUniforms() {}

    static void set(ShaderProgram program, Matrix4fc modelToWorld, Matrix4fc worldToClip) {
        program.set("modelToWorld", modelToWorld);
        program.set("normalToWorld", normalToWorld(modelToWorld));
        program.set("mirror", modelToWorld.determinant3x3() < 0 ? -1f : 1f);
        program.set("worldToClip", worldToClip);
    }

    /** Inverse transpose of the linear part: keeps normals orthogonal to the surface under any scaling. */
    static Matrix3f normalToWorld(Matrix4fc modelToWorld) {
        return modelToWorld.normal(new Matrix3f());
    }
}
