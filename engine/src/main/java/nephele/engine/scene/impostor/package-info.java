/**
 * Pictures of models from many directions, made once: {@code ImpostorAtlas} holds those of a kind from the directions of
 * {@code HemiOctahedron}; {@code ViewBlend} says which of them show it to an eye.
 */
package nephele.engine.scene.impostor;
