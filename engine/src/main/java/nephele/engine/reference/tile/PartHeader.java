package nephele.engine.reference.tile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The head of a part file: which picture it belongs to, and which fraction of it it holds.
 *
 * @param facts what the picture depends on, in words, by name; parts of one picture have the same
 */
public record PartHeader(PixelTiles tiles, Shard shard, Map<String, String> facts) {
    private static final String FIRST_LINE = "nephele-part 1";
    private static final String SIZE = "size";
    private static final String SHARD = "shard";

    /** @throws IllegalArgumentException if a fact has a line break or the name of a line of the head's own */
    public PartHeader {
        facts = Map.copyOf(facts);
        facts.forEach((name, value) -> {
            if (!name.matches("[a-z]+") || name.equals(SIZE) || name.equals(SHARD) || value.contains("\n")) {
                throw new IllegalArgumentException(name + " " + value + " can't be in the head of a part");
            }
        });
    }

    /** Returns the head as text, which ends with an empty line. */
    String text() {
        var lines = new ArrayList<String>();
        lines.add(FIRST_LINE);
        lines.add(SIZE + " " + tiles.width() + "x" + tiles.height());
        lines.add(SHARD + " " + shard);
        facts.keySet().stream().sorted().forEach(name -> lines.add(name + " " + facts.get(name)));
        return String.join("\n", lines) + "\n\n";
    }

    /** Reads what {@link #text} wrote; returns {@code null} if it is something else. */
    static PartHeader parse(String text) {
        List<String> lines = text.lines().toList();
        var values = new LinkedHashMap<String, String>();
        for (String line : lines.subList(Math.min(1, lines.size()), lines.size())) {
            int space = line.indexOf(' ');
            if (space > 0) {
                values.put(line.substring(0, space), line.substring(space + 1));
            }
        }
        try {
            String[] size = values.remove(SIZE).split("x");
            var tiles = new PixelTiles(Integer.parseInt(size[0]), Integer.parseInt(size[1]));
            var header = new PartHeader(tiles, Shard.parse(values.remove(SHARD)), values);
            return header.text().equals(text) ? header : null;
        } catch (IllegalArgumentException | NullPointerException | ArrayIndexOutOfBoundsException unusable) {
            return null;
        }
    }

    /** Returns how the picture of another part differs, as "samples 64, not 32"; empty if it is the same picture. */
    String difference(PartHeader other) {
        var differing = new ArrayList<String>();
        if (!tiles.equals(other.tiles)) {
            differing.add(SIZE + " " + size(other) + ", not " + size(this));
        }
        facts.keySet().stream().sorted().forEach(name -> {
            String value = other.facts.getOrDefault(name, "missing");
            if (!value.equals(facts.get(name))) {
                differing.add(name + " " + value + ", not " + facts.get(name));
            }
        });
        return String.join("; ", differing);
    }

    private static String size(PartHeader header) {
        return header.tiles.width() + "x" + header.tiles.height();
    }
}
