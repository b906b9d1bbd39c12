package sunbeam.app.render;

import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import jrtr.scene.SceneGraph;
import jrtr.scene.SceneGraph.Node;
import jrtr.scene.View;
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

    void applyRaysTo(ShaderProgram program, Tile block) {
        SceneGraphs.view(view, mesh.bounds()).applyRaysTo(program, new View.Area(width, height, block));
    }

    /**
     * Returns the matrix from (x, y, depth) to world space: x and y in pixels from the block's lower left, depth as in the depth buffer.
     */
    Matrix4f blockToWorld(Tile block) {
        Matrix4f toClip = SceneGraphs.view(view, mesh.bounds()).worldToClip(new View.Area(width, height, block));
        return toClip.invert().translate(-1, -1, -1).scale(2f / block.width(), 2f / block.height(), 2);
    }

    SceneGraph graph(ShaderProgram program) {
        Faces faces = closed && SceneGraphs.seesFromOutside(view, mesh.bounds()) ? Faces.FRONT : Faces.BOTH;
        boolean isShaded = program.isActive("shadowMap");
        if (isShaded) {
            shadows.applyTo(program, shadowLight.isPresent());
        }
        Map<String, Texture> further = isShaded ? shadows.textures() : Map.of();
        Node.Shape shape = body.shape(mesh, program, rotatePatch, faces, further);
        return new SceneGraph(SceneGraphs.turned(orientation, shape), SceneGraphs.view(view, mesh.bounds()));
    }
}
