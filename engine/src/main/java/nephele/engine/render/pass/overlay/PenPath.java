package nephele.engine.render.pass.overlay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Collects the strokes of one letter: lines, and arcs divided into chords far shorter than a pixel. */
final class PenPath {
    private static final double DEGREES_PER_CHORD = 12;

    private final List<double[]> strokes = new ArrayList<>();
    private double[] points = new double[256];
    private int length;

    /** Executes the command at {@code words[at]}; returns the number of words that it took. */
    int follow(String[] words, int at) {
        switch (words[at]) {
            case "M":
                lift();
                go(number(words, at + 1), number(words, at + 2));
                return 3;
            case "L":
                go(number(words, at + 1), number(words, at + 2));
                return 3;
            case "A":
                arc(Arrays.stream(words, at + 1, at + 7)
                        .mapToDouble(Double::parseDouble)
                        .toArray());
                return 7;
            default:
                throw new IllegalArgumentException("strokes.txt: unknown pen command " + words[at]);
        }
    }

    List<double[]> strokes() {
        lift();
        return List.copyOf(strokes);
    }

    private void arc(double[] centreRadiiAngles) {
        double from = centreRadiiAngles[4];
        double to = centreRadiiAngles[5];
        int chords = (int) Math.ceil(Math.abs(to - from) / DEGREES_PER_CHORD);
        for (int i = 0; i <= chords; i++) {
            double angle = Math.toRadians(from + (to - from) * i / chords);
            go(
                    centreRadiiAngles[0] + centreRadiiAngles[2] * Math.cos(angle),
                    centreRadiiAngles[1] + centreRadiiAngles[3] * Math.sin(angle));
        }
    }

    private void go(double x, double y) {
        points[length++] = x;
        points[length++] = y;
    }

    private void lift() {
        if (length > 0) {
            strokes.add(Arrays.copyOf(points, length));
        }
        length = 0;
    }

    private static double number(String[] words, int at) {
        return Double.parseDouble(words[at]);
    }
}
