package nephele.editor.brush;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A reason for refusing an edit of brushes, in English, Brazilian and European Portuguese. */
public enum BrushText implements Text {
    NOTHING_LEFT("Nothing would be left of the brush", "Não sobraria nada do bloco", "Não sobrava nada do bloco"),
    TOO_THIN(
            "The brush would be thinner than 0.1 mm",
            "O bloco ficaria com menos de 0,1 mm de espessura",
            "O bloco ficava com menos de 0,1 mm de espessura"),
    TOO_MANY_FACES(
            "The brush would have more than 64 faces",
            "O bloco teria mais de 64 faces",
            "O bloco ficava com mais de 64 faces"),
    NOT_SOLID(
            "The planes enclose no bounded solid that can be told apart at this distance from the origin",
            "Os planos não delimitam um sólido que se distinga a esta distância da origem",
            "Os planos não delimitam um sólido que se distinga a esta distância da origem"),
    OUT_OF_WORLD(
            "The brush would reach beyond 10 000 km from the origin",
            "O bloco passaria de 10 000 km da origem",
            "O bloco passava dos 10 000 km da origem"),
    PLANE_MISSES("The plane does not cut the brush", "O plano não corta o bloco", "O plano não corta o bloco"),
    FACE_VANISHES("The face would shrink to nothing", "A face encolheria até sumir", "A face encolhia até desaparecer"),
    VERTEX_VANISHES(
            "A vertex would end inside the brush, which must stay convex",
            "Um vértice ficaria dentro do bloco, que precisa continuar convexo",
            "Um vértice ficava dentro do bloco, que tem de continuar convexo"),
    FLAT("The brush would be flat", "O bloco ficaria plano", "O bloco ficava plano"),
    WALL_TOO_THICK(
            "The walls are too thick to leave a hollow",
            "As paredes são grossas demais para deixar um vão",
            "As paredes são demasiado grossas para deixar um vão"),
    NO_OVERLAP("The brushes do not overlap", "Os blocos não se sobrepõem", "Os blocos não se sobrepõem"),
    NO_BRUSHES("Select at least one brush", "Selecione ao menos um bloco", "Seleciona pelo menos um bloco"),
    TOO_MANY_VERTICES(
            "These brushes have too many vertices to merge at once: merge fewer",
            "Estes blocos têm vértices demais para unir de uma vez: una menos",
            "Estes blocos têm demasiados vértices para unir de uma vez: une menos"),
    BAD_OPTIONS(
            "These numbers of the shape do not fit the box",
            "Estes números da forma não cabem na caixa",
            "Estes números da forma não cabem na caixa");

    private final Words words;

    BrushText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
