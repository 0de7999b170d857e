package nephele.scenes.xml;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** The elements of one dialect, with their children and attributes, in any capitals. */
final class Vocabulary {
    /** What authors call an element, anywhere; nothing depends on it. */
    private static final String NAME = "name";

    private static final String COORDINATES = "x y z";
    private static final String POSITION = "posx posy posz";
    private static final String LIGHT = "type cutoff exponent dirx diry dirz spotdirx spotdiry spotdirz " + POSITION;
    private static final String COLOURS = "diffR diffG diffB ambtR ambtG ambtB specR specG specB emisR emisG emisB";

    private static final Vocabulary SCENE = new Vocabulary(List.of(
            Word.of("scene", "group models model lights light", ""),
            Word.of("group", "group translate rotate scale models model lights light", ""),
            Word.of("translate", "point", COORDINATES + " time align"),
            Word.of("point", "", COORDINATES),
            Word.of("rotate", "", COORDINATES + " axisX axisY axisZ angle time"),
            Word.of("scale", "", COORDINATES),
            Word.of("models", "model", ""),
            Word.of("model", "", "file texture shininess " + COLOURS),
            Word.of("lights", "light", ""),
            Word.of("light", "", LIGHT)));

    private static final Vocabulary WORLD = new Vocabulary(List.of(
            Word.of("world", "window camera lights group models", ""),
            Word.of("window", "", "width height"),
            Word.of("camera", "position lookAt up projection", ""),
            Word.of("position", "", COORDINATES),
            Word.of("lookAt", "", COORDINATES),
            Word.of("up", "", COORDINATES),
            Word.of("projection", "", "fov near far"),
            Word.of("lights", "light", ""),
            Word.of("light", "", LIGHT),
            Word.of("group", "group transform models", ""),
            Word.of("transform", "translate rotate scale", ""),
            Word.of("translate", "point", COORDINATES + " time align"),
            Word.of("point", "", COORDINATES),
            Word.of("rotate", "", COORDINATES + " axisX axisY axisZ angle time"),
            Word.of("scale", "", COORDINATES),
            Word.of("models", "model", ""),
            Word.of("model", "texture color", "file"),
            Word.of("texture", "", "file"),
            Word.of("color", "diffuse ambient specular emissive shininess", ""),
            Word.of("diffuse", "", "R G B"),
            Word.of("ambient", "", "R G B"),
            Word.of("specular", "", "R G B"),
            Word.of("emissive", "", "R G B"),
            Word.of("shininess", "", "value")));

    private final Map<String, Word> words = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);

    private Vocabulary(List<Word> words) {
        words.forEach(word -> this.words.put(word.name(), word));
    }

    static Vocabulary of(Dialect dialect) {
        return switch (dialect) {
            case SCENE -> SCENE;
            case WORLD -> WORLD;
        };
    }

    /** One element. @param children as they are spelt @param attributes in any capitals */
    record Word(String name, Set<String> children, Set<String> attributes) {
        static Word of(String name, String children, String attributes) {
            Set<String> anyCapitals = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
            anyCapitals.addAll(words(attributes));
            anyCapitals.add(NAME);
            return new Word(name, words(children), anyCapitals);
        }

        private static Set<String> words(String listed) {
            return listed.isEmpty() ? Set.of() : Set.of(listed.split(" "));
        }

        /** Returns true if it nests to any depth; only its own end tag closes it. */
        boolean isFrame() {
            return name.equals("group") || name.equals("scene") || name.equals("world");
        }
    }

    /** Returns the element. @return {@code null} for an unknown one */
    Word word(String name) {
        return words.get(name);
    }

    Collection<String> names() {
        return words.keySet();
    }

    /** Returns a question to append to a warning; empty if no known name is similar. */
    static String suggestion(String name, Collection<String> known) {
        String nearest = null;
        int least = 3;
        for (String candidate : known) {
            int distance = edits(name.toLowerCase(Locale.ROOT), candidate.toLowerCase(Locale.ROOT));
            if (distance < least && distance < candidate.length()) {
                nearest = candidate;
                least = distance;
            }
        }
        return nearest == null ? "" : "; did you mean '" + nearest + "'?";
    }

    /** Returns the number of letters to insert, delete, replace or transpose (Damerau 1964, no letter twice). */
    private static int edits(String from, String to) {
        int[][] distance = new int[from.length() + 1][to.length() + 1];
        for (int i = 0; i <= from.length(); i++) {
            for (int j = 0; j <= to.length(); j++) {
                distance[i][j] = i == 0 || j == 0 ? i + j : leastEdits(distance, from, to, i, j);
            }
        }
        return distance[from.length()][to.length()];
    }

    private static int leastEdits(int[][] distance, String from, String to, int i, int j) {
        boolean same = from.charAt(i - 1) == to.charAt(j - 1);
        int least =
                Math.min(distance[i - 1][j - 1] + (same ? 0 : 1), 1 + Math.min(distance[i - 1][j], distance[i][j - 1]));
        boolean swapped =
                i > 1 && j > 1 && from.charAt(i - 1) == to.charAt(j - 2) && from.charAt(i - 2) == to.charAt(j - 1);
        return swapped ? Math.min(least, distance[i - 2][j - 2] + 1) : least;
    }
}
