package sunbeam.app.files.plot;

import java.awt.Dimension;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.ImageHandlerBase64Encoder;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.apache.batik.svggen.SimpleImageHandler;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.text.Text;

/** SVG whose text is outlines, so that a reader without the font sees it; its bitmaps are inside. */
final class SvgFile {
    private static final String SVG = "http://www.w3.org/2000/svg";

    private SvgFile() {}

    static void write(OutputStream stream, Drawing drawing, double width, Map<String, String> text) throws IOException {
        SVGGeneratorContext context = SVGGeneratorContext.createDefault(document());
        context.setComment("Sunbeam " + Environment.version());
        context.setGenericImageHandler(new SimpleImageHandler(new PngHandler()));
        SVGGraphics2D graphics = new SVGGraphics2D(context, true);
        graphics.setSVGCanvasSize(new Dimension(drawing.width(), drawing.height()));
        drawing.content().accept(graphics);
        Element root = graphics.getRoot();
        double millimeters = 1000 * width;
        root.setAttribute("width", Text.format("%.3fmm", millimeters));
        root.setAttribute("height", Text.format("%.3fmm", millimeters * drawing.height() / drawing.width()));
        root.setAttribute("viewBox", "0 0 " + drawing.width() + " " + drawing.height());
        Element description = root.getOwnerDocument().createElementNS(SVG, "desc");
        description.setTextContent(text.entrySet().stream()
                .map(entry -> entry.getKey() + ": " + entry.getValue())
                .collect(Collectors.joining("\n")));
        root.insertBefore(description, root.getFirstChild());
        Writer writer = new OutputStreamWriter(stream, StandardCharsets.UTF_8);
        graphics.stream(root, writer, false, false);
        writer.flush();
    }

    /** Encodes bitmaps by Java's own writer; Batik's is in a library of many more. */
    private static final class PngHandler extends ImageHandlerBase64Encoder {
        @Override
        public void encodeImage(RenderedImage image, OutputStream stream) throws SVGGraphics2DIOException {
            try {
                ImageIO.write(image, "png", stream);
            } catch (IOException failure) {
                throw new SVGGraphics2DIOException(failure);
            }
        }
    }

    private static Document document() {
        try {
            return DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .getDOMImplementation()
                    .createDocument(SVG, "svg", null);
        } catch (ParserConfigurationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
