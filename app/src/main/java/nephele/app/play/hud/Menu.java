package nephele.app.play.hud;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.app.settings.GameSetting;
import nephele.app.window.Control;
import nephele.engine.asset.Picture;
import nephele.host.compare.TechniquePair;
import nephele.host.named.LevelName;

/**
 * A page of the menu as a value: lines of text, then entries, one of them selected. Keys move the selection cyclically,
 * the mouse selects an entry by its row.
 *
 * @param name the page's name in logs
 * @param lines texts between title and entries
 * @param centred the row about which a list is shown that is longer than the window: keys take it with the selection,
 *     while the pointer selects what it is over, and only its wheel moves the list
 * @param escape the choice of the Esc key
 * @param foot the line below the entries that explains the keys
 */
public record Menu(
        String name,
        String title,
        List<String> lines,
        List<Entry> entries,
        int selected,
        int centred,
        Choice escape,
        String foot) {
    private static final int LETTERS_OF_LINE = 40;
    private static final int MOST_LINES = 3;

    /**
     * A line of the menu and the choice that it makes.
     *
     * @param value text at the right end; empty for none
     * @param choice {@code null} for an entry that can only be read
     * @param help a sentence below the entries while this one is selected; empty for none
     * @param card shown beside the menu while the entry is selected; {@code null} for none
     */
    public record Entry(String label, String value, Choice choice, String help, Card card) {
        public Entry(String label, String value, Choice choice) {
            this(label, value, choice, "", null);
        }

        public Entry(String label, Choice choice) {
            this(label, "", choice);
        }

        /** Returns this entry with a sentence of help. */
        public Entry helped(String sentence) {
            return new Entry(label, value, choice, sentence, card);
        }

        /** Returns this entry with a card. */
        public Entry with(Card shown) {
            return new Entry(label, value, choice, help, shown);
        }
    }

    /**
     * The details of an entry, beside the menu.
     *
     * @param picture {@code null} for none
     * @param text below the facts; its line ends begin new paragraphs
     */
    public record Card(Picture picture, List<Fact> facts, String text) {
        public Card {
            facts = List.copyOf(facts);
        }
    }

    /**
     * A line of a card: a name at its left end, a value at its right end.
     *
     * @param aim what the value is measured by, in a column of its own; empty for none
     */
    public record Fact(String name, String value, String aim) {
        public Fact(String name, String value) {
            this(name, value, "");
        }
    }

    /** Returns a long text in lines that fit into the menu; its end is cut if it is longer than three. */
    public static List<String> broken(String text) {
        List<String> lines = new ArrayList<>(List.of(""));
        for (String word : text.split(" ")) {
            String last = lines.get(lines.size() - 1);
            if (last.isEmpty() || last.length() + 1 + word.length() <= LETTERS_OF_LINE) {
                lines.set(lines.size() - 1, (last + " " + word).strip());
            } else if (lines.size() == MOST_LINES) {
                lines.set(lines.size() - 1, last + " …");
                break;
            } else {
                lines.add(word);
            }
        }
        return List.copyOf(lines);
    }

    /** A page that an entry opens. */
    public enum Page {
        LEVELS,
        SAMPLES,
        YOUR_LEVELS,
        SETTINGS,
        KEYS,
        RESTART_QUESTION
    }

    /** A choice of the player. */
    public sealed interface Choice {
        /** A choice that is the same wherever it is made. */
        enum Plain implements Choice {
            /** Returns to the running level. */
            RESUME,
            RESTART,
            TO_TITLE,
            /** Returns to the page before. */
            BACK,
            QUIT
        }

        /** Starts a level from its beginning. */
        record Play(LevelName level) implements Choice {}

        /** Starts a level whose clouds two techniques draw, with a wipe between them. */
        record Compare(LevelName level, TechniquePair techniques) implements Choice {}

        /** Shows an XML scene in its viewer. */
        record Show(String scene) implements Choice {}

        record Open(Page page) implements Choice {}

        /** Opens the settings of a group. */
        record OpenSettings(GameSetting.Group group) implements Choice {}

        /** Opens the samples of a group, by its place in the catalogue. */
        record OpenSamples(int group) implements Choice {}

        /** Shows a folder in the system's own window for files. */
        record ShowFolder(Path folder) implements Choice {}

        /** Changes a setting by a step. */
        record Step(GameSetting<?> setting, int step) implements Choice {}

        /** Waits for a key that becomes the control's first one. */
        record Bind(Control control) implements Choice {}
    }

    public Menu {
        lines = List.copyOf(lines);
        entries = List.copyOf(entries);
        if (entries.isEmpty() || selected < 0 || selected >= entries.size()) {
            throw new IllegalArgumentException("entry " + selected + " of " + entries.size() + " is selected");
        }
    }

    /** Returns true if an entry has a card. */
    boolean hasCards() {
        return entries.stream().anyMatch(entry -> entry.card() != null);
    }

    /** Returns true if an entry has a sentence of help. */
    boolean hasHelp() {
        return entries.stream().anyMatch(entry -> !entry.help().isEmpty());
    }

    /** Returns the selected entry. */
    Entry entry() {
        return entries.get(selected);
    }

    /** Returns the menu with the selection moved, around both ends. */
    public Menu moved(int steps) {
        int row = Math.floorMod(selected + steps, entries.size());
        return showing(row, row);
    }

    /** Returns the menu with that row selected; rows outside change nothing. */
    public Menu pointedAt(int row) {
        return row >= 0 && row < entries.size() ? showing(row, centred) : this;
    }

    /** Returns the menu with the list shown about that row. */
    public Menu centredAt(int row) {
        return showing(selected, row);
    }

    /** Returns the menu with the selection of another one, as far as it has as many entries, at the same place. */
    public Menu like(Menu other) {
        return centredAt(other.centred).pointedAt(other.selected);
    }

    private Menu showing(int row, int middle) {
        return new Menu(name, title, lines, entries, row, middle, escape, foot);
    }

    /** Returns the choice of the selected entry; {@code null} if it makes none. */
    public Choice chosen() {
        return entries.get(selected).choice();
    }

    /** Returns the choice of the left (−1) or right key (+1): a step of a setting, else null. */
    public Choice stepped(int direction) {
        return chosen() instanceof Choice.Step step ? new Choice.Step(step.setting(), direction) : null;
    }
}
