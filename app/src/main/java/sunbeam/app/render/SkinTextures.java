package sunbeam.app.render;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import jrtr.gl.ImageTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import jrtr.scene.PlacedMesh;
import org.joml.Quaternionfc;
import sunbeam.app.scene.mesh.SnakeBody;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.ScaleRelief;
import sunbeam.app.scene.texture.Scales;

/** Textures of a mesh's surface in graphics memory (shaders/include/relief.glsl). */
final class SkinTextures implements AutoCloseable {
    private final Body body;
    private final ImageTexture colors;
    private final ImageTexture relief;
    private final ImageTexture directions;
    private final ImageTexture patches;

    private SkinTextures(Body body, List<ImageTexture> uploaded) {
        this.body = body;
        this.colors = uploaded.get(0);
        this.relief = uploaded.get(1);
        this.directions = uploaded.get(2);
        this.patches = uploaded.get(3);
    }

    static SkinTextures upload(RenderContext context, Body body) {
        List<ImageTexture> uploaded = new ArrayList<>();
        try {
            uploaded.add(upload(context, "body", body.colors(), ImageTexture.Encoding.SRGB));
            uploaded.add(upload(context, "relief", body.relief(), ImageTexture.Encoding.LINEAR));
            uploaded.add(upload(context, "directions", body.directions(), ImageTexture.Encoding.LINEAR));
            uploaded.add(upload(context, "patches", body.patches(), ImageTexture.Encoding.LINEAR));
            return new SkinTextures(body, uploaded);
        } catch (RuntimeException failure) {
            uploaded.forEach(ImageTexture::close);
            throw failure;
        }
    }

    private static ImageTexture upload(
            RenderContext context, String label, BodyTexture texture, ImageTexture.Encoding encoding) {
        return context.createImageTexture(label, texture.width(), texture.height(), texture.rgba(), encoding);
    }

    @SuppressWarnings("ReferenceEquality") // comparing texels would take as long as uploading them
    boolean isOf(Body other) {
        return body == other;
    }

    /** Returns a mesh with these textures in world space, and sets the program's uniforms about them. */
    PlacedMesh placed(
            VertexBuffer mesh,
            Quaternionfc orientation,
            ShaderProgram program,
            double rotatePatch,
            Faces faces,
            Map<String, Texture> furtherTextures) {
        Map<String, Texture> textures = new HashMap<>(furtherTextures);
        textures.put("skinRelief", relief);
        textures.put("patchDirections", directions);
        if (program.isActive("bodyTexture")) {
            textures.put("bodyTexture", colors);
        }
        PlacedMesh.turnTangents(program, rotatePatch);
        boolean hasScales = body.scales() != Scales.NONE;
        double scalesPerUnit = hasScales ? SnakeBody.scalesPerUnit(body.scales().rows()) : 0;
        program.set("reliefPerUnit", (float) (scalesPerUnit / ScaleRelief.SCALES_ALONG));
        program.set("reliefBegin", (float) (hasScales ? ScaleRelief.BEGIN : 0));
        program.set("reliefSteepest", (float) (hasScales ? ScaleRelief.STEEPEST : 0));
        if (program.isActive("reliefLightest")) {
            program.set("reliefLightest", (float) ScaleRelief.LIGHTEST);
        }
        if (program.isActive("patchMap")) {
            textures.put("patchMap", patches);
        }
        if (program.isActive("patchColor")) {
            program.set("patchColor", (float) body.patchColor());
        }
        return new PlacedMesh(mesh, Framing.toWorld(orientation, mesh.bounds()), program, textures, faces);
    }

    @Override
    public void close() {
        patches.close();
        directions.close();
        relief.close();
        colors.close();
    }
}
