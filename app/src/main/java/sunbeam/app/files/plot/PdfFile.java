package sunbeam.app.files.plot;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2DFontTextDrawer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Map;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDDocumentInformation;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.pdmodel.font.PDType0Font;
import sunbeam.app.terminal.Environment;

/** PDF of one page with embedded fonts. The same drawing gives the same bytes: no date, and a constant identifier. */
final class PdfFile {
    private static final double POINTS_PER_METER = 72 / 0.0254;

    private PdfFile() {}

    static void write(OutputStream stream, Drawing drawing, double width, Map<String, String> text) throws IOException {
        double scale = width * POINTS_PER_METER / drawing.width();
        PDRectangle size = new PDRectangle((float) (scale * drawing.width()), (float) (scale * drawing.height()));
        try (PDDocument document = new PDDocument();
                PdfBoxGraphics2DFontTextDrawer fonts = new PdfBoxGraphics2DFontTextDrawer();
                InputStream plain = PlotFont.open("Regular");
                InputStream bold = PlotFont.open("Bold")) {
            document.setDocumentId(0L);
            fonts.registerFont(PlotFont.plain(1).getFontName(), PDType0Font.load(document, plain, true));
            fonts.registerFont(PlotFont.bold(1).getFontName(), PDType0Font.load(document, bold, true));
            PDPage page = new PDPage(size);
            document.addPage(page);
            PdfBoxGraphics2D graphics = new PdfBoxGraphics2D(document, size);
            graphics.setFontTextDrawer(fonts);
            graphics.scale(scale, scale);
            drawing.content().accept(graphics);
            graphics.dispose();
            try (PDPageContentStream content = new PDPageContentStream(document, page)) {
                content.drawForm(graphics.getXFormObject());
            }
            PDDocumentInformation information = document.getDocumentInformation();
            text.forEach(information::setCustomMetadataValue);
            information.setProducer("Sunbeam " + Environment.version());
            document.save(stream);
        }
    }
}
