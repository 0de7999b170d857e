package nephele.lab.technique;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import nephele.engine.asset.AtomicFile;
import nephele.engine.choice.ErrorTable;
import nephele.engine.choice.ErrorTable.Row;
import nephele.engine.level.CloudTechnique;
import nephele.lab.trade.Numbers;

/** The pages of the report on clouds besides its subjects: the section with which it opens, and one about each technique. */
public final class CloudPages {
    private static final double DISTANT_DEGREES = 5;
    private static final double NEAR_DEGREES = 30;
    private static final double THIN = 0.3;
    private static final double THICK = 40;
    private static final String ABOUT =
            """
            <p class="about">In 2004 a dissertation on virtual clouds closed with a table of its techniques: hardware, cost and \
            expertise, in words. Here it is again, measured, with the marching of rays as a sixth one. Errors are those of radiance \
            against a path tracer, root mean squares over blocks of a tenth of the picture's width that show the cloud, in per cent of \
            its mean radiance. Costs are the CPU time that one cloud adds to a frame of 640 × 384 pixels, in full-screen textured quads. Both are \
            medians over forms of cloud and heights of the sun; distant clouds take up %s degrees of the view, near ones %s, thin ones have a mean \
            optical depth of %s, thick ones of %s. Lines are those of Java and GLSL in the technique's own folder; light, air and \
            composition are shared by all. Draws are those at quality high, at half the resolution; texture units are those of \
            the largest program under an even sky: air takes one more, and surfaces among clouds another.</p>
            """;
    private static final String CONCLUSION =
            """
            <p class="so">The techniques are additive, as was found in 2004: particles near, billboards farther away, sheets beyond and a \
            skybox last, all in one sky. <code>"technique": "auto"</code> doses them: each cloud gets the cheapest one whose \
            measured error is allowed where the eye can be.</p>
            """;
    private static final String MISSING =
            """
            <p class="about">Errors and costs are not measured yet: <code>trade clouds</code> without <code>--quick</code> \
            measures them.</p>
            """;
    private static final String HEAD =
            """
            <tr><th rowspan="2">technique</th><th class="spread" colspan="4">suited for clouds that are</th>\
            <th rowspan="2">OpenGL beyond textures and blending</th><th class="figure" rowspan="2">draws a frame</th>\
            <th class="figure" rowspan="2">texture units</th><th class="spread" colspan="2">error distant, %</th>\
            <th class="spread" colspan="2">error near, %</th><th class="spread" colspan="2">cost, quads</th>\
            <th rowspan="2">an author sets</th><th class="figure" rowspan="2">lines</th><th rowspan="2">in 2004</th></tr>
            <tr><th class="mark">distant</th><th class="mark">prominent</th><th class="mark">near</th><th class="mark">crossable</th>\
            <th class="figure">thin</th><th class="figure">thick</th><th class="figure">thin</th><th class="figure">thick</th>\
            <th class="figure">distant</th><th class="figure">near</th></tr>
            """;

    private CloudPages() {}

    /**
     * Writes a page about each technique beside the report.
     *
     * @param width of their pictures in pixels
     */
    public static void write(Path folder, int width, int height, PrintStream log) throws IOException {
        try (var pictures = new PagePictures(folder.resolve("pictures"), width, height, log)) {
            for (CloudTechnique technique : TechniqueText.ALL) {
                String page = new HandoutPage(TechniqueText.of(technique), pictures::address).html();
                AtomicFile.write(folder.resolve(HandoutPage.file(technique)), page.getBytes(StandardCharsets.UTF_8));
            }
        }
    }

    /**
     * Returns the section with which the report opens, as HTML: the table of 2004, which had words, with measured figures in
     * it, one row a technique.
     */
    public static String opening(ErrorTable table) {
        String rows = TechniqueText.ALL.stream()
                .map(technique -> row(TechniqueText.of(technique), table))
                .collect(Collectors.joining("\n"));
        return "<section id=\"techniques\"><h2>The table of 2004, measured</h2>\n"
                + ABOUT.formatted(
                        Numbers.of(DISTANT_DEGREES), Numbers.of(NEAR_DEGREES), Numbers.of(THIN), Numbers.of(THICK))
                + (table.rows().isEmpty() ? MISSING : "")
                + "<div class=\"wide\"><table class=\"techniques\">\n" + HEAD + rows + "</table></div>\n" + CONCLUSION
                + "</section>\n";
    }

    private static String row(TechniqueText text, ErrorTable table) {
        CloudTechnique technique = text.technique();
        var row = new StringBuilder("<tr><td><a href=\"" + HandoutPage.file(technique) + "\"><b>"
                + TechniqueText.word(technique) + "</b></a></td>");
        for (String purpose : TechniqueText.PURPOSES) {
            row.append("<td class=\"mark\">")
                    .append(text.isSuited(purpose) ? "●" : "")
                    .append("</td>");
        }
        cell(row, "", text.one("needs"));
        cell(row, "figure", text.one("draws"));
        cell(row, "figure", text.one("units"));
        for (double angle : new double[] {DISTANT_DEGREES, NEAR_DEGREES}) {
            for (double depth : new double[] {THIN, THICK}) {
                cell(row, "figure", median(table, technique, angle, depth, Row::errorPercent));
            }
        }
        cell(row, "figure", median(table, technique, DISTANT_DEGREES, Double.NaN, Row::cost));
        cell(row, "figure", median(table, technique, NEAR_DEGREES, Double.NaN, Row::cost));
        cell(row, "", text.one("parameters"));
        cell(row, "figure", text.one("lines"));
        cell(row, "then", text.one("then"));
        return row.append("</tr>").toString();
    }

    private static void cell(StringBuilder row, String style, String html) {
        row.append(style.isEmpty() ? "<td>" : "<td class=\"" + style + "\">")
                .append(html)
                .append("</td>");
    }

    /** @param depth NaN for all */
    private static String median(
            ErrorTable table, CloudTechnique technique, double angle, double depth, ToDoubleFunction<Row> of) {
        List<Double> values = table.rows().stream()
                .filter(row -> row.technique() == technique && row.angularDegrees() == angle)
                .filter(row -> Double.isNaN(depth) || row.opticalDepth() == depth)
                .map(of::applyAsDouble)
                .sorted()
                .toList();
        int size = values.size();
        return size == 0 ? "–" : Numbers.of((values.get((size - 1) / 2) + values.get(size / 2)) / 2);
    }
}
