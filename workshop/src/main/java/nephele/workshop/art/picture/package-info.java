/** Pictures beside the materials: skies, signs, globes and the pictures of the XML scenes. */
package nephele.workshop.art.picture;
