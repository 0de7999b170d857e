package nephele.editor.widget;

import java.util.Map;
import java.util.Optional;
import javax.swing.Icon;

/** The symbols of kinds of entities and of brush shapes, as small as a line of text. */
public final class EntityIcons {
    private static final int SIDE_POINTS = 16;

    /** The drawings by section and kind, or by section alone, in the notation of {@link Symbol}. */
    private static final Map<String, String> DRAWINGS = Symbol.table(
            """
            player                   o 12,5.5,3|6.5,21 6.5,14 9,11 15,11 17.5,14 17.5,21 z
            observer                 o 12,12,5.2|*o 12,12,1.8|3,7.5 3,3 7.5,3|16.5,3 21,3 21,7.5|21,16.5 21,21 16.5,21|\
            7.5,21 3,21 3,16.5
            par                      o 12,13.5,7.5|12,13.5 12,8.5|12,13.5 15.5,15.5|9.5,2.5 14.5,2.5|12,2.5 12,6
            exits                    6,21 6,3 18,3 18,21|3,21 21,21|*o 15,12.5,1.6
            landmark                 6,21 6,3|6,4 18,4 15,8 18,12 6,12|*o 6,21,1.5
            hints                    9,8.5 9.5,5.5 12,4 15,5.5 15.5,8.5 13,11.5 12,13.5 12,15.5|*o 12,19.5,1.4
            bodies.box               3.5,8 12,4 20.5,8 12,12 z|3.5,8 3.5,16.5 12,20.5 20.5,16.5 20.5,8|12,12 12,20.5
            bodies.sphere            o 12,12,8.5|o 12,12,8.5,3
            bodies.capsule           7.5,8 7.5,16 9,19 12,20.5 15,19 16.5,16 16.5,8 15,5 12,3.5 9,5 z|7.5,8 16.5,8|\
            7.5,16 16.5,16
            portals                  o 12,12,6,9|*o 12,12,2,4
            portalGun                3,8 15,6 20,9 20,13 15,15 3,14 z|7,14 6,20 10.5,20 11.5,14.5|*o 15.5,10.7,2
            lights.point             o 12,9.5,6|9.5,15.5 9.5,18.5 14.5,18.5 14.5,15.5|10.5,21.5 13.5,21.5
            lights.spot              *8.5,3 15.5,3 17,8 7,8 z|7.5,11 3,20.5|16.5,11 21,20.5|12,11 12,20.5
            environment.sun          *o 12,12,4|12,2 12,5|12,19 12,22|2,12 5,12|19,12 22,12|5,5 7,7|17,17 19,19|\
            5,19 7,17|17,7 19,5
            environment.clouds       6,18.5 3.5,16.3 3.5,13.5 5.5,11.3 8,11 9.2,8 12,6.5 15,7.4 16.6,10 19,10.4 21,12.6 \
            20.7,16 18.5,18.5 z
            environment.sky          3,20 21,20|4,15.5 8,11.5 12,10.3 16,11.5 20,15.5|4,9.5 8,5.5 12,4.3 16,5.5 20,9.5
            environment.sky.constant *3.5,4.5 20.5,4.5 20.5,19.5 3.5,19.5 z
            environment.sky.gradient 3.5,4.5 20.5,4.5 20.5,19.5 3.5,19.5 z|*3.5,4.5 20.5,4.5 20.5,9 3.5,9 z|\
            3.5,12.3 20.5,12.3|3.5,15.8 20.5,15.8
            environment.sky.skybox   9,3 15,3 15,9 21,9 21,15 15,15 15,21 9,21 9,15 3,15 3,9 9,9 z|9,9 15,9 15,15 9,15 z
            environment.fog          3,6.5 17,6.5|7,10.5 21,10.5|3,14.5 16,14.5|8,18.5 21,18.5
            environment.lightning    *13.5,2.5 5.5,13.5 11,13.5 9.5,21.5 18.5,9.5 12.7,9.5 z
            emitters                 9,21 5.5,17 6.5,12 10,8.5 10.5,3 15,7.5 15.5,11 17,9.5 18.8,14 17.5,18.5 15,21 z|\
            *o 12,16.5,2
            terrains                 2.5,19.5 9,7 12.5,13 15.5,9.5 21.5,19.5 z|7,10.8 9,12.4 11,10.5|2.5,19.5 21.5,19.5
            billboards               12,2.5 17.5,9.5 14.5,9.5 18.5,15.5 5.5,15.5 9.5,9.5 6.5,9.5 z|12,15.5 12,21|8,21 16,21
            models                   8.5,3 15.5,3|10,3 10,7 5.5,12 5.5,16 8.5,21 15.5,21 18.5,16 18.5,12 14,7 14,3
            cameras                  2.5,7 15,7 15,17.5 2.5,17.5 z|15,11 21.5,7 21.5,17.5 15,13.5
            materials                3.5,3.5 20.5,3.5 20.5,20.5 3.5,20.5 z|*3.5,3.5 12,3.5 12,12 3.5,12 z|\
            *12,12 20.5,12 20.5,20.5 12,20.5 z
            solids                   3.5,8 12,4 20.5,8 12,12 z|3.5,8 3.5,16.5 12,20.5 20.5,16.5 20.5,8|12,12 12,20.5
            solids.planes            12,3 20,7 18.5,16 12,21 5,15.5 4,7 z|4,7 12,10 20,7|12,10 12,21
            other                    12,4 20,12 12,20 4,12 z
            """);

    private EntityIcons() {}

    /** Returns the symbol of a kind of entity of a section, both as files have them. */
    public static Icon of(String section, String kind) {
        return Symbol.of(drawing(section, kind).orElse(DRAWINGS.get("other")), SIDE_POINTS);
    }

    /** Returns the drawing of a kind, empty for a kind without one. */
    static Optional<String> drawing(String section, String kind) {
        String ofKind = DRAWINGS.get(section + "." + kind);
        String shape = section.equals("solids") ? ToolIcons.shapeDrawing(solidShape(kind)) : null;
        return Optional.ofNullable(ofKind != null ? ofKind : shape != null ? shape : DRAWINGS.get(section));
    }

    private static String solidShape(String kind) {
        return kind.equals("prism") ? "cylinder" : kind;
    }

    /** Returns the symbol of a shape of brushes, such as {@code stairs}. */
    public static Icon ofShape(String shape) {
        return Symbol.of(ToolIcons.shapeDrawing(shape), SIDE_POINTS);
    }
}
