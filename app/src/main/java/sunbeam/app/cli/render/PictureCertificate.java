package sunbeam.app.cli.render;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import sunbeam.app.cli.options.CertifyOption;
import sunbeam.app.cli.report.ReportFields;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.measure.errors.Certificate;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** Comparison of an anti-aliased picture, including the body's light, with points of the same scene by method full. */
record PictureCertificate(FrameSequence frames, Scene drawn, PrintWriter out, PrintWriter err) {
    /** Tolerance of the exact points: a quarter of the limit of the picture's median error. */
    private static final double POINT_TOLERANCE = 5e-3;

    /** Compares random pixels, adds the certificate to the report, and returns the exit code that the picture deserves. */
    ExitCode judge(RenderContext context, Environment environment, int count, Map<String, Object> report) {
        Scene points = drawn.withMethod(drawn.method()
                .with(Choices.none().with(Methods.METHOD, FullMethod.TYPE).with(TOLERANCE, POINT_TOLERANCE)));
        try {
            List<SceneData> exact =
                    new SceneLoader(environment, warning -> {}).parts(points, frames.parts(), share -> {});
            Certificate certificate = frames.certify(context, drawn, exact, count);
            report.put("certificate", ReportFields.of(certificate));
            // Errors of the table at the footprints of this picture's pixels; a larger --supersample does not reduce
            // them.
            List<ErrorStatistics> tables = frames.tableErrors(drawn);
            tables.forEach(errors -> out.println("table: " + errors + " at " + errors.count() + " samples"));
            Optional<String> miss = tables.stream()
                    .flatMap(
                            errors -> VirtualTexture.miss(errors, drawn.method().get(TOLERANCE)).stream())
                    .findFirst();
            boolean isTable = drawn.method().type().equals(TableMethod.TYPE);
            String remedy = miss.orElse(
                    "a larger --supersample or --size" + (isTable ? "" : ", or --method table,") + " may help");
            ExitCode judged = CertifyOption.judge(certificate, true, remedy, out, err);
            if (judged != ExitCode.OK || miss.isEmpty()) {
                return judged;
            }
            err.println(Messages.error(miss.get()));
            return ExitCode.TOLERANCE_MISSED;
        } catch (GraphicsException failure) {
            throw new GraphicsException("the picture is written, but cannot be compared: " + failure.getMessage()
                    + "; or leave --certify out");
        }
    }
}
