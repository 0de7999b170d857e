package nephele.editor.play;

import java.util.Locale;
import nephele.editor.text.Words;
import nephele.engine.level.Language;

/** A text of play and solutions in English, Brazilian and European Portuguese. */
public enum PlayText {
    STARTING("Starting the game …", "Abrindo o jogo …", "A abrir o jogo …"),
    PLAYING(
            "Playing; Esc in the game comes back here",
            "Jogando; Esc no jogo volta para cá",
            "A jogar; Esc no jogo volta para aqui"),
    BAKING("Baking the light: %s %%", "Calculando a luz: %s %%", "A calcular a luz: %s %%"),
    ENDED("Back from the game", "De volta do jogo", "De volta do jogo"),
    EXIT_REACHED(
            "Exit reached after %s s with %s portals",
            "Saída alcançada após %s s com %s portais", "Saída alcançada ao fim de %s s com %s portais"),
    RECORDED("Solution recorded: %s", "Solução gravada: %s", "Solução gravada: %s"),
    NOT_RECORDED(
            "The exit was not reached: no solution was recorded",
            "A saída não foi alcançada: nenhuma solução foi gravada",
            "A saída não foi alcançada: não foi gravada nenhuma solução"),
    CHECKING("Replaying the solution: %s %%", "Repetindo a solução: %s %%", "A repetir a solução: %s %%"),
    SOLVED(
            "Solved at tick %s, after %s s with %s portals",
            "Resolvido no tique %s, após %s s com %s portais", "Resolvido no tique %s, ao fim de %s s com %s portais"),
    STRAYS_AT_FIRST(
            "first astray at tick %s, %s s: %s",
            "primeiro desvio no tique %s, aos %s s: %s", "primeiro desvio no tique %s, aos %s s: %s"),
    NOT_SOLVED("Not solved", "Não resolvido", "Não resolvido"),
    ELSEWHERE(
            "the player is %s m from the recorded place",
            "o jogador está a %s m do lugar gravado", "o jogador está a %s m do lugar gravado"),
    PORTAL_REFUSED(
            "a shot places no portal that placed one",
            "um tiro que abria um portal já não o abre",
            "um tiro que abria um portal já não o abre"),
    EXIT_NOT_REACHED(
            "the recording ends before the exit",
            "a gravação termina antes da saída",
            "a gravação termina antes da saída");

    private final String english;
    private final String brazilian;
    private final String european;

    PlayText(String english, String brazilian, String european) {
        this.english = english;
        this.brazilian = brazilian;
        this.european = european;
    }

    /** Returns the text with its values filled in. */
    public String in(Language language, Object... values) {
        String text =
                switch (language) {
                    case EN -> english;
                    case PT_BR -> brazilian;
                    case PT_PT -> european;
                };
        return values.length == 0 ? text : String.format(Locale.ROOT, text, values);
    }

    /** Returns the sentence for a verdict. */
    public static String of(SolutionVerdict verdict, Language language) {
        String result = verdict.exit()
                .map(exit -> SOLVED.in(language, exit.tick(), number(exit.seconds()), exit.portals()))
                .orElse(NOT_SOLVED.in(language));
        return verdict.deviation()
                .map(first -> result + "; "
                        + STRAYS_AT_FIRST.in(language, first.tick(), number(first.seconds()), cause(first, language)))
                .orElse(result);
    }

    /** Returns the sentence for the end of a play. */
    public static Words of(PlayEnd end) {
        return end.recorded() != null
                ? RECORDED.words(end.recorded())
                : end.exitReached() ? EXIT_REACHED.words(number(end.exitSeconds()), end.portals()) : ENDED.words();
    }

    /** Returns the text in all languages, with its values filled in. */
    public Words words(Object... values) {
        return Words.of(in(Language.EN, values), in(Language.PT_BR, values), in(Language.PT_PT, values));
    }

    private static String cause(SolutionVerdict.Deviation deviation, Language language) {
        return switch (deviation.cause()) {
            case ELSEWHERE ->
                ELSEWHERE.in(
                        language,
                        number(deviation.place().minus(deviation.expected()).length()));
            case PORTAL_REFUSED -> PORTAL_REFUSED.in(language);
            case EXIT_NOT_REACHED -> EXIT_NOT_REACHED.in(language);
        };
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }
}
