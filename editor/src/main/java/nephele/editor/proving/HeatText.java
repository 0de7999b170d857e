package nephele.editor.proving;

import java.util.Locale;
import nephele.editor.text.Text;
import nephele.editor.text.Words;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;

/** A text of the heat map in English, Brazilian and European Portuguese. */
public enum HeatText implements Text {
    FITS("A portal fits here", "Um portal cabe aqui", "Um portal cabe aqui"),
    SLIDES("A portal slides %s m to fit", "Um portal desliza %s m para caber", "Um portal desliza %s m para caber"),
    NOTHING_HIT("No portal: nothing is there", "Sem portal: não há nada ali", "Sem portal: não há nada ali"),
    OUT_OF_RANGE("No portal: too far away", "Sem portal: longe demais", "Sem portal: demasiado longe"),
    MOVING_SURFACE(
            "No portal: something that moves is in the way",
            "Sem portal: algo que se move está no caminho",
            "Sem portal: algo que se move está no caminho"),
    NOT_PORTALABLE(
            "No portal: this surface takes none",
            "Sem portal: esta superfície não aceita portais",
            "Sem portal: esta superfície não aceita portais"),
    NOT_FLAT(
            "No portal: the ground is uneven by %s mm here, allowed are 10",
            "Sem portal: o chão tem %s mm de desnível aqui, são permitidos 10",
            "Sem portal: o chão tem %s mm de desnível aqui, são permitidos 10"),
    OVERLAPS_OTHER(
            "No portal: another portal is in its place",
            "Sem portal: outro portal está no lugar",
            "Sem portal: outro portal está no lugar"),
    TOO_SMALL(
            "No portal: the surface is too small",
            "Sem portal: a superfície é pequena demais",
            "Sem portal: a superfície é demasiado pequena"),
    EDGE("No portal: too near the edge", "Sem portal: perto demais da borda", "Sem portal: demasiado perto da borda"),
    OCCUPIED(
            "No portal: something stands in the old one",
            "Sem portal: algo está no portal antigo",
            "Sem portal: algo está no portal antigo");

    private static final Words LEGEND_FITS = Words.of("fits", "cabe", "cabe");
    private static final Words LEGEND_SLIDES = Words.of("slides to fit", "desliza para caber", "desliza para caber");

    private static final Words LEGEND_NOT_FLAT =
            Words.of("the ground is uneven", "o chão é irregular", "o chão é irregular");

    private final Words words;

    HeatText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }

    /** Returns the text for a refusal. */
    public static HeatText of(Refusal refusal) {
        return valueOf(refusal.name());
    }

    /**
     * Returns the text in all languages; a number of metres fills its place, if it has one: of the slide, or of the
     * ground's unevenness.
     */
    public Words words(double metres) {
        if (this == NOT_FLAT) {
            return words.with(PlacementResult.Refused.millimetres(metres));
        }
        String number = String.format(Locale.ROOT, "%.2f", metres);
        String withComma = number.replace('.', ',');
        return words.with(Words.of(number, withComma, withComma));
    }

    /** Returns the text for a legend: without a number, and a refusal by its reason alone. */
    public Words legend() {
        return switch (this) {
            case FITS -> LEGEND_FITS;
            case SLIDES -> LEGEND_SLIDES;
            case NOT_FLAT -> LEGEND_NOT_FLAT;
            default -> Words.of(reason(words.english()), reason(words.brazilian()), reason(words.european()));
        };
    }

    private static String reason(String refusal) {
        return refusal.substring(refusal.indexOf(": ") + 2);
    }
}
