package sunbeam.app.render;

import java.util.List;
import java.util.Optional;
import jrtr.Faces;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.ShaderProgram;
import jrtr.gl.VertexBuffer;
import jrtr.scene.Frustum;
import jrtr.scene.Material;
import jrtr.scene.PictureArea;
import jrtr.scene.SceneGraph;
import jrtr.scene.ViewRays;
import org.joml.Matrix4f;
import org.joml.Quaternionfc;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Viewpoint;

/**
 * All that determines what each pixel of a picture shows before it is lit.
 *
 * @param mesh triangles
 * @param closed whether they enclose a body
 * @param body their textures
 * @param view from where
 * @param orientation as {@link Scene#orientation()}
 * @param rotatePatch as {@link SceneSettings#ROTATE_PATCH}
 * @param shadows of the mesh
 * @param shadowLight towards the light that casts those that are part of it; empty without
 * @param width pixels per row of the whole picture
 * @param height rows of the whole picture
 */
record SkinGeometry(
        VertexBuffer mesh,
        boolean closed,
        SkinTextures body,
        Viewpoint view,
        Quaternionfc orientation,
        double rotatePatch,
        Shadows shadows,
        Optional<Vector3fc> shadowLight,
        int width,
        int height) {

    /** Towards the viewer from what the pixels of a block show. */
    ViewRays viewRays(Tile block) {
        return ViewRays.of(
                view.camera(), SceneGraphs.frustum(view, mesh.bounds()), new PictureArea(width, height, block));
    }

    /** From places in a block, counted from its lower left, and their depth to world space. */
    Matrix4f blockToWorld(Tile block) {
        Frustum frustum = SceneGraphs.frustum(view, mesh.bounds());
        Matrix4f toClip = frustum.cameraToClip(new PictureArea(width, height, block))
                .mul(view.camera().worldToCamera());
        return toClip.invert().translate(-1, -1, -1).scale(2f / block.width(), 2f / block.height(), 2);
    }

    /** For a {@linkplain GeometryLayout#shader() program} that notes it. */
    SceneGraph graph(ShaderProgram program) {
        Faces faces = closed && SceneGraphs.seesFromOutside(view, mesh.bounds()) ? Faces.FRONT : Faces.BOTH;
        boolean isShaded = program.isActive("shadowMap");
        if (isShaded) {
            shadows.applyTo(program, shadowLight.isPresent());
        }
        List<Binding> further = isShaded ? List.of(shadows.binding()) : List.of();
        Material material = body.material(program, rotatePatch, faces, further);
        return SceneGraphs.unlit(view, orientation, mesh, material);
    }
}
