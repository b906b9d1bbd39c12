package sunbeam.app.render;

import jrtr.gl.ShaderProgram;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.colortable.ColorTable;

/** Computes and sets the uniforms of shaders/include/footprint.glsl. */
final class FootprintUniforms {
    private FootprintUniforms() {}

    /**
     * @param scene scene whose fine relief widens footprints, unless the table's levels include it
     * @param isCoarsest whether all footprints read the coarsest level
     */
    static void apply(
            ShaderProgram program, ColorTable table, Scene scene, int mostTaps, int samplesAcross, boolean isCoarsest) {
        boolean hasRelief = table.slopeDeviation() > 0;
        program.set("finestVariance", (float) Math.pow(table.finestSigma(), 2));
        program.set("pointVariance", (float) Math.pow(table.sigma(), 2));
        program.set("tabulatedSlopeVariance", (float) Math.pow(table.slopeDeviation(), 2));
        program.set("slopeVariance", hasRelief ? 0 : (float) Math.pow(scene.slopeDeviation(), 2));
        program.set("pointLevels", (float) table.pointLevelCount());
        program.set("levels", table.levels().size() - table.pointLevelCount());
        program.set("leastLevel", isCoarsest ? table.levels().size() - 1f : 0);
        program.set("mostTaps", (float) mostTaps);
        program.set("samplesAcross", (float) samplesAcross);
    }
}
