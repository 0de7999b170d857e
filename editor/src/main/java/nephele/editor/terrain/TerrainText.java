package nephele.editor.terrain;

import java.util.Locale;
import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of painting terrains in English, Brazilian and European Portuguese. */
public enum TerrainText implements Text {
    SAVE_FIRST(
            "Save the level first: strokes on terrains make files in its folder",
            "Salve a fase antes: as pinceladas no terreno criam arquivos na pasta dela",
            "Guarda o nível primeiro: as pinceladas no terreno criam ficheiros na pasta dele"),
    NO_TERRAIN(
            "There is no terrain here: Add has one",
            "Não há terreno aqui: Adicionar tem um",
            "Não há terreno aqui: Adicionar tem um"),
    LOCKED("The terrain %s is locked", "O terreno %s está travado", "O terreno %s está bloqueado"),
    NO_RANGE(
            "The terrain %s can only be flat: give it a range of heights",
            "O terreno %s só pode ser plano: dê a ele uma faixa de alturas",
            "O terreno %s só pode ser plano: dá-lhe um intervalo de alturas"),
    AT_LIMIT(
            "Heights of this terrain end at %s m and %s m: its range can be changed",
            "As alturas deste terreno vão de %s m a %s m: a faixa pode ser mudada",
            "As alturas deste terreno vão de %s m a %s m: o intervalo pode ser mudado"),
    FEW_LAYERS(
            "The terrain %s has no layers to choose from: give it two or more",
            "O terreno %s não tem camadas para escolher: dê a ele duas ou mais",
            "O terreno %s não tem camadas para escolher: dá-lhe duas ou mais"),
    NO_LAYER(
            "The terrain %s has no layer %s: choose another one",
            "O terreno %s não tem a camada %s: escolha outra", "O terreno %s não tem a camada %s: escolhe outra"),
    TOO_WEAK(
            "Too weak to replace the layer that is painted here: go over it more often, or with more strength",
            "Fraco demais para substituir a camada pintada aqui: passe mais vezes, ou com mais força",
            "Fraco de mais para substituir a camada pintada aqui: passa mais vezes, ou com mais força"),
    NOT_KEPT("The stroke is lost: %s", "A pincelada se perdeu: %s", "A pincelada perdeu-se: %s"),
    UNUSABLE("It can't be painted: %s", "Não pode ser pintado: %s", "Não pode ser pintado: %s"),
    PAINT("Paint %s", "Pintar %s", "Pintar %s"),
    PAINT_BRUSH("%s: radius %s m, strength %s %%", "%s: raio %s m, força %s %%", "%s: raio %s m, força %s %%"),
    BRUSH(
            "%s: radius %s m, strength %s %%, height %s m",
            "%s: raio %s m, força %s %%, altura %s m", "%s: raio %s m, força %s %%, altura %s m");

    private final Words words;

    TerrainText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }

    /** Returns a number without zeros at its end. */
    public static String number(double number) {
        String text = String.format(Locale.ROOT, "%.2f", number + 0.0);
        return text.replaceAll("\\.?0+$", "");
    }
}
