/** Does rendering work on this machine? */
package sunbeam.app.cli.doctor;
