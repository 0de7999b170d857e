package nephele.editor.widget;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.Icon;

/** The symbols of tools and actions, drawn from lines: no picture files, sharp at every scale, in every theme. */
public final class ToolIcons {
    static final int SIDE_POINTS = 20;

    /** In the notation of {@link SymbolDrawing}. */
    private static final Map<String, String> DRAWINGS = SymbolDrawing.table(
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

    private ToolIcons() {}

    /** Returns the symbol of an id, or of the word of it that has one, or else a letter of the title. */
    public static Icon of(String id, String title) {
        if (OptionDrawings.ALL.containsKey(id)) {
            return SymbolDrawing.icon(OptionDrawings.ALL.get(id), SIDE_POINTS);
        }
        for (String word : id.toLowerCase(Locale.ROOT).split("[.\\-_ ]")) {
            if (DRAWINGS.containsKey(word)) {
                return SymbolDrawing.icon(DRAWINGS.get(word), SIDE_POINTS);
            }
        }
        String letter = title.isEmpty() ? "?" : title.substring(0, Math.min(2, title.length()));
        return new Symbol(List.of(), List.of(), letter, SIDE_POINTS);
    }
}
