package nephele.lab.trade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import nephele.engine.measure.ErrorMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Reports of invented figures contain the expected words. */
class ReportTest {
    private static final Circumstances MADE = new Circumstances(
            "A <level>", "levels/a.json", "16×9 pixels", "a machine", "a rasteriser", "0123abc", "2026-01-01");

    @TempDir
    Path folder;

    /**
     * Returns findings of four settings: fast has a large error, middle is nearly right at half the price, fine is the
     * best, and waste is dearer than fine and no better.
     */
    private static Findings findings(double... costs) {
        return findingsWithFast(9, costs);
    }

    private static Findings findingsWithFast(double errorOfFast, double... costs) {
        var trade = new Trade(
                "knob",
                new Trade.Text("A knob & more", "Turns something.", "the \"truth\""),
                List.of(),
                List.of(Setting.of("fast"), Setting.of("middle"), new Setting("fine", "a, note"), Setting.of("waste")),
                2,
                new ErrorMetric("error", "mm", 0.1, 1),
                List.of("other, %"),
                new CostMetric("CPU a thing", "ms", 1e6, 1, CostMetric.Clock.THREAD),
                null,
                site -> null);
        double[] errors = {errorOfFast, 2.5, 2, 2};
        SubjectState state = SubjectState.NOTHING;
        for (double error : errors) {
            state = state.with(new SubjectState.Judged(error, List.of(50.0), false));
        }
        for (int round = 0; round < 12; round++) {
            List<Cost> row = new ArrayList<>();
            for (double cost : costs) {
                double load = 1 + round % 3 * 0.5;
                row.add(new Cost(1e6 * cost * load * (1 + 0.001 * (round % 2)), 1e6, 64));
            }
            state = state.withRound(row);
        }
        return Findings.of(trade, state);
    }

    @Test
    void choosesTheCheapestThatErrsLittleMoreThanTheBest() {
        var advice = new Advice(findings(1, 4, 8, 12));
        assertEquals(
                "Choose “middle”: its error of 2.5\u00a0mm is within 1\u00a0mm of the best (“fine”, 2\u00a0mm),"
                        + " and it costs 50 % less.",
                advice.choice());
        String remarks = String.join("\n", advice.remarks());
        assertFalse(remarks.contains("Where time is short"), remarks);
        assertTrue(remarks.contains("What is usual today, “fine”, costs 2.00 times as much"), remarks);
        assertTrue(remarks.contains("never choose: “waste” (“fine” costs less and errs no more)"), remarks);
        assertFalse(remarks.contains("busy"), remarks);
    }

    /**
     * An error of half as much again as the best plus {@code enough} is accepted for use under time pressure; four
     * times as much is not.
     */
    @Test
    void namesWhatIsCheapAndErrsLittle() {
        String remarks = String.join("\n", new Advice(findingsWithFast(3.9, 1, 4, 8, 12)).remarks());
        assertTrue(remarks.contains("Where time is short: “fast” is had for 75 % less"), remarks);
    }

    @Test
    void keepsTheUsualWhereNothingIsCheaperBeyondDoubt() {
        var advice = new Advice(findings(8.1, 7.9, 8, 8.05));
        assertEquals("Choose “fine”: nothing is clearly cheaper, and nothing errs clearly less.", advice.choice());
        assertFalse(String.join(" ", advice.remarks()).contains("usual today"));
    }

    @Test
    void csvHasOneLineASettingAndAsManyCellsAsTheHead() {
        var lines = Report.csv(List.of(findings(1, 4, 8, 12))).lines().toList();
        assertEquals(5, lines.size());
        int cells = lines.get(0).split(",", -1).length;
        for (String line : lines) {
            assertEquals(cells, line.replaceAll("\"[^\"]*\"", "").split(",", -1).length, line);
        }
        assertTrue(lines.get(2).startsWith("knob,middle,false,true,,error,mm,2.50000,CPU a thing,ms,"), lines.get(2));
        assertTrue(lines.get(4).startsWith("knob,waste,false,false,fine,"), lines.get(4));
    }

    @Test
    void plotsAreWellFormedAndHoldEverySetting() throws Exception {
        for (double[] costs : new double[][] {{1, 4, 8, 12}, {1, 200, 8, 12}, {8, 8, 8, 8}}) {
            String svg = CostErrorPlot.of(findings(costs), HtmlDocument.resource("page.css"));
            var document = parsed(svg);
            assertEquals(4, count(document, "circle", "point"));
            assertEquals(1, count(document, "circle", "ring"));
            assertFalse(svg.contains("NaN"), svg);
            for (String name : new String[] {"fast", "middle", "fine", "waste"}) {
                assertTrue(svg.contains(">" + name + "</text>"), name);
            }
        }
    }

    @Test
    void thePageNeedsNoOtherFileAndEscapesWhatItWasTold() throws IOException {
        Report.write(List.of(findings(1, 4, 8, 12)), MADE, folder);
        String page = Files.readString(folder.resolve("index.html"));
        assertTrue(page.contains("A &lt;level&gt;") && page.contains("A knob &amp; more"), "escaped");
        assertFalse(page.matches("(?s).*(src|href)=\"(?!data:|#).*"), "refers to another file");
        assertFalse(page.contains("http://") && !page.contains("http://www.w3.org/2000/svg"), "refers to the network");
        for (String element : new String[] {"section", "table", "svg", "tr", "td", "div", "script", "style"}) {
            assertEquals(
                    page.split("<" + element + "[ >]", -1).length,
                    page.split("</" + element + ">", -1).length,
                    element);
        }
        parsed(Files.readString(folder.resolve("plots/knob.svg")));
        assertTrue(Files.readString(folder.resolve("trade.csv")).startsWith(Report.CSV_HEADER));
    }

    @Test
    void picturesAreSavedAndMissed() throws IOException {
        var trade = findings(1, 4, 8, 12).trade();
        var pictures = new Pictures(folder);
        var image = new java.awt.image.BufferedImage(2, 2, java.awt.image.BufferedImage.TYPE_INT_RGB);
        var state = SubjectState.NOTHING.with(new SubjectState.Judged(1, List.of(), true));
        assertFalse(pictures.complete(trade, state));
        pictures.save(trade, 0, new Judgement(1, List.of(), image, new ErrorMap(2, 2, new float[] {0, 0.2f, 0.8f, 1})));
        pictures.saveExact(trade, image);
        assertTrue(pictures.complete(trade, state));
        assertTrue(Pictures.dataAddress(pictures.error(trade, 0)).startsWith("data:image/jpeg;base64,"));
    }

    /** Lightness grows with the error: 0 is the darkest colour, 1 the lightest. */
    @Test
    void heatGrowsLighter() {
        int before = -1;
        for (int i = 0; i <= 20; i++) {
            int colour = Pictures.heatColour(i / 20.0);
            int lightness = 2 * (colour >> 16 & 255) + 7 * (colour >> 8 & 255) + (colour & 255);
            assertTrue(lightness > before, "at " + i);
            before = lightness;
        }
    }

    private static org.w3c.dom.Document parsed(String xml) {
        try {
            return DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .parse(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
        } catch (Exception malformed) {
            throw new AssertionError(xml, malformed);
        }
    }

    private static long count(org.w3c.dom.Document document, String element, String style) {
        var all = document.getElementsByTagName(element);
        long count = 0;
        for (int i = 0; i < all.getLength(); i++) {
            String styles = all.item(i).getAttributes().getNamedItem("class").getNodeValue();
            count += List.of(styles.split(" ")).contains(style) ? 1 : 0;
        }
        return count;
    }
}
