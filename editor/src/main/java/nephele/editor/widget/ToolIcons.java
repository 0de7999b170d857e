package nephele.editor.widget;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.Icon;

/** The symbols of tools and actions, drawn from lines: no picture files, sharp at every scale, in every theme. */
public final class ToolIcons {
    private static final int SIDE_POINTS = 20;

    /** The drawings by name, in the notation of {@link Symbol}. */
    private static final Map<String, String> DRAWINGS = Symbol.table(
            """
            select     *5,3 5,19 9.2,15.4 12,21.5 14.6,20.3 11.9,14.4 17.5,14 z
            brush      4,8 12,4 20,8 12,12 z|4,8 4,16 12,20 20,16 20,8|12,12 12,20
            extrude    4,14 12,10 20,14 12,18 z|12,13 12,3|8.5,6.5 12,3 15.5,6.5
            face       *4,8 12,4 20,8 12,12 z|4,8 4,16 12,20 20,16 20,8|12,12 12,20
            vertex     5,18 12,5 19,18 z|*o 5,18,2.6|*o 12,5,2.6|*o 19,18,2.6
            edge       6,5 18,19|*o 6,5,2.4|*o 18,19,2.4
            clip       4,7 4,20 17,20 17,16|4,7 9,7|3,22 21,3|*o 14,10.4,2
            rotate     19,8 16,5 12,4 8,5.2 5,8.5 4,12.5 5.5,17 9,19.6 13,20 17,18 19.6,14.5|19.6,3 19,8 14,8.4
            scale      4,13 4,20 11,20 11,13 z|11,13 20,4|14,4 20,4 20,10
            move       12,3 12,21|3,12 21,12|9.5,5.5 12,3 14.5,5.5|9.5,18.5 12,21 14.5,18.5|5.5,9.5 3,12 \
            5.5,14.5|18.5,9.5 21,12 18.5,14.5
            paint      5,4 17,4 17,9 5,9 z|17,6.5 20,6.5 20,12 12,13 12,15|*10.5,15 13.5,15 13.5,21 10.5,21 z
            texture    4,4 20,4 20,20 4,20 z|*4,4 12,4 12,12 4,12 z|*12,12 20,12 20,20 12,20 z
            portal     o 12,12,6,9|*o 12,12,2,4
            portalable 3.5,3.5 20.5,3.5 20.5,20.5 3.5,20.5 z|o 12,12,4,6.2
            terrain    2.5,20 8,10 11.5,15 15.5,6 21.5,20 z|*13.6,10.4 15.5,6 17.3,10.4 15.5,11.6 z
            place      12,21 6.5,13 6,9 8,5 12,3.4 16,5 18,9 17.5,13 z|*o 12,9.5,2.4
            measure    3,16 16,3 21,8 8,21 z|7,12 9,14|10,9 13,12|13,6 15,8
            camera     3,7 15,7 15,17 3,17 z|15,11 21,7.5 21,16.5 15,13
            light      o 12,10,5|9.5,15.5 9.5,18 14.5,18 14.5,15.5|10.5,21 13.5,21
            sun        *o 12,12,3.6|12,2.5 12,5|12,19 12,21.5|2.5,12 5,12|19,12 21.5,12|5.3,5.3 7,7|17,17 \
            18.7,18.7|5.3,18.7 7,17|17,7 18.7,5.3
            undo       9,4.5 4,9.5 9,14.5|4,9.5 15,9.5 18.5,11 20,14 19,17.5 15.5,19.5 11,19.5
            redo       15,4.5 20,9.5 15,14.5|20,9.5 9,9.5 5.5,11 4,14 5,17.5 8.5,19.5 13,19.5
            save       4,4 17,4 20,7 20,20 4,20 z|8,4 8,9 15,9 15,4|7,20 7,13 17,13 17,20
            open       3,19 3,5 9,5 11,8 20,8 20,11|3,19 7,11 22,11 18,19 z
            new        6,3 14,3 19,8 19,21 6,21 z|14,3 14,8 19,8
            play       *7,4 20,12 7,20 z
            check      4,12 9.5,18 20,5
            heat       3,3 21,3 21,21 3,21 z|9,3 9,21|15,3 15,21|3,9 21,9|3,15 21,15|*9,9 15,9 15,15 9,15 z|\
            *3,3 9,3 9,9 3,9 z
            trace      3,4 12,18 21,4|3,4 3,8.5|3,4 7,5.5|*3,18 21,18 21,20.5 3,20.5 z
            explain    o 12,12,9|9,10 9.5,7.5 12,6.5 14.6,7.6 15,10 12,12.2 12,14.5|*o 12,17.6,1.2
            delete     5,7 19,7|7,7 8,20 16,20 17,7|10,7 10,4 14,4 14,7
            duplicate  4,4 15,4 15,15 4,15 z|9,15 9,20 20,20 20,9 15,9
            """);

    private static final String FRAME = "4,4 20,4 20,20 4,20 z";
    private static final String CUBE = "4,8 12,4 20,8 12,12 z|4,8 4,16 12,20 20,16 20,8|12,12 12,20";

    private static final String PORTALABLE = "*4,8 12,12 12,20 4,16 z|" + CUBE;
    private static final String SCREEN = "3,5 21,5 21,19 3,19 z";

    private static final String GROUND = "2.5,20 6,19 9,15.5 12,14.5 15,15.5 18,19 21.5,20 z";

    /** The symbols of the option bar by the ids of actions. */
    private static final Map<String, String> OPTIONS = Map.ofEntries(
            Map.entry(
                    "lit",
                    "*o 12,12,4|12,2.5 12,5|12,19 12,21.5|2.5,12 5,12|19,12 21.5,12|5.3,5.3 7,7|17,17"
                            + " 18.7,18.7|5.3,18.7 7,17|17,7 18.7,5.3"),
            Map.entry(
                    "tool-sun",
                    "*12,8 14.8,9.2 16,12 16,15 8,15 8,12 9.2,9.2 z|3,15 21,15|6,18.5 18,18.5|12,2.5 12,5|4.5,6.5"
                            + " 6.3,8.3|19.5,6.5 17.7,8.3"),
            Map.entry("tool-portalable", PORTALABLE),
            Map.entry("unlit", "*4,8 12,4 20,8 20,16 12,20 4,16 z"),
            Map.entry("portalable", PORTALABLE),
            Map.entry("collision", "12,3 20,6 19,14 12,21 5,14 4,6 z"),
            Map.entry("wireframe", CUBE + "|4,16 12,12 20,16|12,4 12,12"),
            Map.entry("one-pane", SCREEN),
            Map.entry("two-panes", SCREEN + "|12,5 12,19"),
            Map.entry("four-panes", SCREEN + "|12,5 12,19|3,12 21,12"),
            Map.entry("grid-finer", "4,4 4,20|8,4 8,20|12,4 12,20|16,4 16,20|20,4 20,20|4,12 20,12"),
            Map.entry("grid-coarser", "4,4 4,20|12,4 12,20|20,4 20,20|4,12 20,12"),
            Map.entry("snap-grid", "8,3 8,21|16,3 16,21|3,8 21,8|3,16 21,16|*o 8,8,3"),
            Map.entry("snap-vertex", "3,19 12,8 21,19|*o 12,8,3.4"),
            Map.entry("snap-absolute", "4,4 20,4 20,20 4,20 z|12,4 12,20|4,12 20,12|*o 12,12,3.4"),
            Map.entry("snap-surface", "2,17 14,20 22,14 10,11 z|12,3 12,14|9,11 12,14.5 15,11"),
            Map.entry("shape-box", CUBE),
            Map.entry("shape-wedge", "3,18 15,21 21,17 21,7 15,10 3,18|15,10 15,21|3,18 9,15 21,7"),
            Map.entry("shape-stairs", "3,20 3,15 9,15 9,10 15,10 15,5 21,5 21,20 z"),
            Map.entry(
                    "shape-arch", "3,20 3,12 6,6 12,3.5 18,6 21,12 21,20 16,20 16,13 14.5,10 12,9 9.5,10 8,13 8,20 z"),
            Map.entry(
                    "shape-cylinder",
                    "4,6.5 8,4.3 12,3.8 16,4.3 20,6.5 16,8.7 12,9.2 8,8.7 z|4,6.5 4,17.5 8,19.7 12,20.2 16,19.7"
                            + " 20,17.5 20,6.5"),
            Map.entry("shape-room", FRAME + "|8,8 16,8 16,16 8,16 z|4,4 8,8|20,4 16,8|20,20 16,16|4,20 8,16"),
            Map.entry("keep-behind", FRAME + "|*4,4 4,20 20,20 z|4,4 20,20"),
            Map.entry("keep-front", FRAME + "|*4,4 20,4 20,20 z|4,4 20,20"),
            Map.entry("keep-both", "*4,6 4,20 18,20 z|*6,4 20,4 20,18 z"),
            Map.entry("terrain-raise", GROUND + "|12,12 12,3|8.5,6.5 12,3 15.5,6.5"),
            Map.entry("terrain-lower", GROUND + "|12,3 12,12|8.5,8.5 12,12 15.5,8.5"),
            Map.entry(
                    "terrain-smooth",
                    "2.5,15 6,11 10,10 14,13 18,14 21.5,11|2.5,20 21.5,20|*2.5,15 6,11 10,10 14,13 18,14 21.5,11"
                            + " 21.5,20 2.5,20 z"),
            Map.entry("terrain-flatten", "*2.5,13 21.5,13 21.5,20 2.5,20 z|5,13 8,7 11,13|14,13 16.5,9 19,13"),
            Map.entry("terrain-paint", GROUND + "|*9,12.5 10,9 12.5,11.5 z|10,9 16.5,2.5 19,5 12.5,11.5"),
            Map.entry("terrain-erase", GROUND + "|*8,9.5 11,6.5 15,10.5 12,13 11,13 z|11,6.5 14.5,3 18.5,7 15,10.5"),
            Map.entry("terrain-smaller", "o 12,12,9|*o 12,12,3"),
            Map.entry("terrain-larger", "o 12,12,9|*o 12,12,7"),
            Map.entry("terrain-weaker", "4,18 20,18|*4,18 20,18 20,15.5 z"),
            Map.entry("terrain-stronger", "4,18 20,18|*4,18 20,18 20,4 z"),
            Map.entry("new-portalable", "4,3 20,3 20,21 4,21 z|*12,6 15,8.5 16,12 15,15.5 12,18 9,15.5 8,12 9,8.5 z"),
            Map.entry("texture-lock", "*5,11 19,11 19,21 5,21 z|8,11 8,7 9.5,4.5 12,3.5 14.5,4.5 16,7 16,11"),
            Map.entry("texture-pick", "4,20 5,16 13,8 16,11 8,19 z|*12,6 14,4 20,10 18,12 z|*15,5 18,3 21,6 19,9 z"),
            Map.entry(
                    "texture-fit",
                    FRAME + "|8,8 11,11|8,11 8,8 11,8|16,8 13,11|13,8 16,8 16,11|8,16 11,13|8,13 8,16 11,16|16,16"
                            + " 13,13|13,16 16,16 16,13"),
            Map.entry("texture-left", "3,3 3,21|*6,6 18,6 18,10 6,10 z|*6,14 13,14 13,18 6,18 z"),
            Map.entry("texture-centre", "12,3 12,21|*5,6 19,6 19,10 5,10 z|*8,14 16,14 16,18 8,18 z"),
            Map.entry("texture-right", "21,3 21,21|*6,6 18,6 18,10 6,10 z|*11,14 18,14 18,18 11,18 z"),
            Map.entry("texture-top", "3,3 21,3|*6,6 10,6 10,18 6,18 z|*14,6 18,6 18,13 14,13 z"),
            Map.entry("texture-middle", "3,12 21,12|*6,5 10,5 10,19 6,19 z|*14,8 18,8 18,16 14,16 z"),
            Map.entry("texture-bottom", "3,21 21,21|*6,6 10,6 10,18 6,18 z|*14,11 18,11 18,18 14,18 z"),
            Map.entry("texture-reset", "6,8 4,4|4,4 9,5|4,4 8,3 13,3.5 18,6 20.5,11 19.5,16 16,19.5 11,20.5 6.5,18.5"));

    private ToolIcons() {}

    /** Returns the symbol of an id, or of the word of it that has one, or else a letter of the title. */
    public static Icon of(String id, String title) {
        if (OPTIONS.containsKey(id)) {
            return Symbol.of(OPTIONS.get(id), SIDE_POINTS);
        }
        for (String word : id.toLowerCase(Locale.ROOT).split("[.\\-_ ]")) {
            if (DRAWINGS.containsKey(word)) {
                return Symbol.of(DRAWINGS.get(word), SIDE_POINTS);
            }
        }
        String letter = title.isEmpty() ? "?" : title.substring(0, Math.min(2, title.length()));
        return new Symbol(List.of(), List.of(), letter, SIDE_POINTS);
    }

    /** Returns the drawing of a shape of brushes, such as {@code stairs}; {@code null} for none. */
    static String shapeDrawing(String shape) {
        return OPTIONS.get("shape-" + shape);
    }
}
