package sunbeam.app.render;

import java.util.Map;
import java.util.Optional;
import jrtr.Faces;
import jrtr.Tile;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import jrtr.scene.Frustum;
import jrtr.scene.Material;
import jrtr.scene.PictureArea;
import jrtr.scene.SceneGraph;
import jrtr.scene.ViewRays;
import org.joml.Matrix4f;
import org.joml.Quaternionfc;
import org.joml.Vector3fc;
import sunbeam.app.scene.Viewpoint;

/**
 * Input of the geometry pass of a picture; equal inputs draw equal attributes.
 *
 * @param closed whether the triangles enclose a body
 * @param rotatePatch rotation of the patch about the normal, radians
 * @param shadowLight direction of the light whose shadows the attributes include; empty for none
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

    ViewRays viewRays(Tile block) {
        return ViewRays.of(
                view.camera(), SceneGraphs.frustum(view, mesh.bounds()), new PictureArea(width, height, block));
    }

    /**
     * Returns the matrix from (x, y, depth) to world space: x and y in pixels from the block's lower left, depth as in the depth buffer.
     */
    Matrix4f blockToWorld(Tile block) {
        Frustum frustum = SceneGraphs.frustum(view, mesh.bounds());
        Matrix4f toClip = frustum.cameraToClip(new PictureArea(width, height, block))
                .mul(view.camera().worldToCamera());
        return toClip.invert().translate(-1, -1, -1).scale(2f / block.width(), 2f / block.height(), 2);
    }

    SceneGraph graph(ShaderProgram program) {
        Faces faces = closed && SceneGraphs.seesFromOutside(view, mesh.bounds()) ? Faces.FRONT : Faces.BOTH;
        boolean isShaded = program.isActive("shadowMap");
        if (isShaded) {
            shadows.applyTo(program, shadowLight.isPresent());
        }
        Map<String, Texture> further = isShaded ? shadows.textures() : Map.of();
        Material material = body.material(program, rotatePatch, faces, further);
        return SceneGraphs.unlit(view, orientation, mesh, material);
    }
}
