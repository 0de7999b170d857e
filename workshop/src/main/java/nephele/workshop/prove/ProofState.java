package nephele.workshop.prove;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;

/** The progress and results of a proof at one commit, saved in a file so that the run can be resumed. */
record ProofState(String commit, ProofResult soFar) {
    static ProofState fresh(String commit) {
        return new ProofState(commit, ProofResult.NOTHING);
    }

    /** Returns the saved state if it belongs to this commit, else a fresh one: changed code has to be proved again. */
    static ProofState load(Path file, String commit) throws IOException {
        if (!Files.exists(file)) {
            return fresh(commit);
        }
        var saved = new Properties();
        saved.load(new StringReader(TextFile.text(Files.readAllBytes(file))));
        if (!commit.equals(saved.getProperty("commit"))) {
            return fresh(commit);
        }
        long units = Long.parseLong(saved.getProperty("units"));
        long failures = Long.parseLong(saved.getProperty("failures"));
        return new ProofState(commit, new ProofResult(units, failures, figures(saved), examples(saved)));
    }

    void save(Path file) throws IOException {
        var saved = new Properties();
        saved.setProperty("commit", commit);
        saved.setProperty("units", Long.toString(soFar.units()));
        saved.setProperty("failures", Long.toString(soFar.failures()));
        for (int i = 0; i < soFar.figures().size(); i++) {
            saveFigure(saved, "figure." + i, soFar.figures().get(i));
        }
        for (int i = 0; i < soFar.examples().size(); i++) {
            saved.setProperty("example." + i, soFar.examples().get(i));
        }
        var text = new StringWriter();
        saved.store(text, null);
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void saveFigure(Properties saved, String key, Figure figure) {
        saved.setProperty(key + ".name", figure.name());
        saved.setProperty(key + ".value", Double.toString(figure.value()));
        saved.setProperty(key + ".unit", figure.unit());
        saved.setProperty(key + ".join", figure.join().name());
    }

    private static List<Figure> figures(Properties saved) {
        var figures = new ArrayList<Figure>();
        for (int i = 0; saved.containsKey("figure." + i + ".name"); i++) {
            String key = "figure." + i;
            figures.add(new Figure(
                    saved.getProperty(key + ".name"),
                    Double.parseDouble(saved.getProperty(key + ".value")),
                    saved.getProperty(key + ".unit"),
                    Figure.Join.valueOf(saved.getProperty(key + ".join"))));
        }
        return figures;
    }

    private static List<String> examples(Properties saved) {
        var examples = new ArrayList<String>();
        for (int i = 0; saved.containsKey("example." + i); i++) {
            examples.add(saved.getProperty("example." + i));
        }
        return examples;
    }
}
