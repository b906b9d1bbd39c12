package sunbeam.app.render;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import jrtr.ColorEncoding;
import jrtr.Faces;
import jrtr.ImageTextureSpec;
import jrtr.Wrap;
import jrtr.gl.Binding;
import jrtr.gl.ImageTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.Material;
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
            uploaded.add(upload(context, "body", body.colors(), ColorEncoding.SRGB));
            uploaded.add(upload(context, "relief", body.relief(), ColorEncoding.LINEAR));
            uploaded.add(upload(context, "directions", body.directions(), ColorEncoding.LINEAR));
            uploaded.add(upload(context, "patches", body.patches(), ColorEncoding.LINEAR));
            return new SkinTextures(body, uploaded);
        } catch (RuntimeException failure) {
            uploaded.forEach(ImageTexture::close);
            throw failure;
        }
    }

    private static ImageTexture upload(
            RenderContext context, String label, BodyTexture texture, ColorEncoding encoding) {
        ImageTexture uploaded = context.createImageTexture(
                label, new ImageTextureSpec(texture.width(), texture.height(), encoding, Wrap.REPEAT));
        uploaded.upload(texture.rgba());
        return uploaded;
    }

    @SuppressWarnings("ReferenceEquality") // comparing texels would take as long as uploading them
    boolean isOf(Body other) {
        return body == other;
    }

    /** Returns the material for a pass that draws the mesh. */
    Material material(ShaderProgram program, double rotatePatch, Faces faces, List<Binding> furtherTextures) {
        List<Binding> textures =
                new ArrayList<>(List.of(new Binding("skinRelief", relief), new Binding("patchDirections", directions)));
        textures.addAll(furtherTextures);
        if (program.isActive("bodyTexture")) {
            textures.add(new Binding("bodyTexture", colors));
        }
        Map<String, Float> uniforms = new HashMap<>(Material.tangentsTurned(rotatePatch));
        boolean hasScales = body.scales() != Scales.NONE;
        double scalesPerUnit = hasScales ? SnakeBody.scalesPerUnit(body.scales().rows()) : 0;
        uniforms.put("reliefPerUnit", (float) (scalesPerUnit / ScaleRelief.SCALES_ALONG));
        uniforms.put("reliefBegin", (float) (hasScales ? ScaleRelief.BEGIN : 0));
        uniforms.put("reliefSteepest", (float) (hasScales ? ScaleRelief.STEEPEST : 0));
        if (program.isActive("reliefLightest")) {
            uniforms.put("reliefLightest", (float) ScaleRelief.LIGHTEST);
        }
        if (program.isActive("patchMap")) {
            textures.add(new Binding("patchMap", patches));
        }
        if (program.isActive("patchColor")) {
            uniforms.put("patchColor", (float) body.patchColor());
        }
        return new Material(program, textures, uniforms, faces);
    }

    @Override
    public void close() {
        patches.close();
        directions.close();
        relief.close();
        colors.close();
    }
}
